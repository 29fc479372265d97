// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_source.h"
#include "core/setup/clicks/click_learning.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Clicks on a target in a recording, and known properties of the target.
struct FootageClicks {
  /// Color samples that the user clicked; the first one is on the target. Their colors are not set
  /// yet.
  std::vector<ColorSample> samples;
  std::optional<std::string> targetName; ///< target name; empty: the only target, or "target 1"
  /// Radius of the target, meters; empty: keep the radius in the project.
  std::optional<double> radius;
  std::optional<TargetShape> shape; ///< shape of the target; empty: keep the shape in the project
};

/// Result of learning from clicks in a recording.
struct FootageLearningResult {
  Project project;        ///< project with the learned color
  std::size_t target = 0; ///< index of the target whose color was learned
  ClickLearningResult learningResult;
  cv::Mat clickedImage; ///< image that contains the first click
};

/// Learns the color of a target from clicks in a recording. The target is a target of the project,
/// or a new target with the given name. The images of the other cameras are searched for the object
/// of the first click. `backgroundImages` are those returned by loadBackgroundImages().
///
/// Returns BadValue, which names "camera" if the cameras are live, "frame" if the frame is after
/// the end of the recording, and "pixel" or "box" if the click is outside the image. Returns
/// MissingKey, which names "target", if there are several targets and none is named. Also returns
/// the errors of learnFromClicks(), checkProject() and the source.
Result<FootageLearningResult> learnFromFootage(Project project, FrameSetSource& source,
                                               const std::vector<cv::Mat>& backgroundImages,
                                               FootageClicks clicks);

} // namespace dewpoint::setup
