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

/// Returns the methods that follow a box through the images of one camera (boxFollowerNames()), in
/// table order. Dewpoint's own methods use 300 particles.
const std::vector<std::string>& imageClipMethods();

/// Follows a clip from its first true box, with the method and seed of `key`, and returns the
/// result for all frames after the first: the RMS distance between found and true centers (pixels),
/// the frames to converge, the lost frames, and the success (BoxMetrics). A frame counts as lost
/// unless the distance is below the clip's radius. `images` are the images of the clip. Returns
/// nothing if `stop` returns true, and NotFound for a method that is not in imageClipMethods().
Result<std::optional<SuiteResult>> followClip(const BoxClip& clip,
                                              const std::vector<cv::Mat>& images, const RunKey& key,
                                              const std::function<bool()>& stop);

} // namespace dewpoint::experiment
