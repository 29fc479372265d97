// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_source.h"
#include "core/setup/clicks/click_lesson.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Clicks on a target in a recording, and what is known about the target.
struct FootageClicks {
  /// Samples; the first one is on the target. Their colors are not set yet.
  std::vector<ColorSample> samples;
  std::optional<std::string> target; ///< its name; empty: the only target, or "target 1"
  std::optional<double> radius;      ///< meters; empty: unchanged
  std::optional<TargetShape> shape;  ///< empty: unchanged
};

/// Result of learning from clicks in a recording.
struct FootageLesson {
  Project project;        ///< with the learned color
  std::size_t target = 0; ///< index of the target whose color was learned
  ClickLesson lesson;
  cv::Mat image; ///< image that contains the first click
};

/// Learns the color of a target from clicks in a recording: one that the project has, or a new one
/// of that name. The other cameras are searched for what the first click shows. BadValue names
/// "camera" when the cameras are live, "frame" beyond the end, "pixel" or "box" outside the image;
/// MissingKey names "target" when there are several and none is named; and errors of
/// learnFromClicks(), checkProject() and the source. `backgroundImages` as of
/// loadBackgroundImages().
Result<FootageLesson> learnFromFootage(Project project, FrameSetSource& source,
                                       const std::vector<cv::Mat>& backgroundImages,
                                       FootageClicks clicks);

} // namespace dewpoint::setup
