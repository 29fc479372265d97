// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/boxes/box_clips.h"
#include "core/experiment/suite/suite_recorder.h"

#include <opencv2/core/mat.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Returns the methods that follow a box through the images of one camera, in table order. They are
/// those of boxFollowerNames(). Dewpoint's own methods use 300 particles.
const std::vector<std::string>& imageClipMethods();

/// Follows a clip with the given images from its first true box, with the method and seed of `key`.
/// Returns nothing if `stop` returns true. The result covers all frames after the first. It
/// contains the RMS distance between found and true centers (pixels), the frames to converge, the
/// lost frames, and the success (BoxMetrics). A frame counts as lost unless the distance is below
/// the clip's radius. Returns NotFound for a method that is not in imageClipMethods().
Result<std::optional<SuiteResult>> followClip(const BoxClip& clip,
                                              const std::vector<cv::Mat>& images, const RunKey& key,
                                              const std::function<bool()>& stop);

} // namespace dewpoint::experiment
