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

/// Methods that follow a box through the images of one camera, in the order of the tables:
/// boxFollowerNames(), ours with 300 particles.
const std::vector<std::string>& imageMethods();

/// Follows a clip with the given images from its first true box, with the method and the seed of
/// `key`. Returns nothing if `stop` returns true. Over all frames after the first, it measures the
/// RMS distance of the centers in pixels, frames to converge and lost frames by the clip's radius,
/// and success. NotFound for a method that imageMethods() does not have.
Result<std::optional<SuiteResult>> followClip(const BoxClip& clip,
                                              const std::vector<cv::Mat>& images, const RunKey& key,
                                              const std::function<bool()>& stop);

} // namespace dewpoint::experiment
