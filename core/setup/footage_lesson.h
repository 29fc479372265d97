// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_source.h"
#include "core/setup/click_lesson.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Clicks on a target in a recording, and what is known of the target.
struct FootageClicks {
  /// The first one is on the target; the colors of none are taken yet.
  std::vector<ColorSample> samples;
  std::optional<std::string> target; ///< its name; nothing: the only one, or "target 1"
  std::optional<double> radius;      ///< meters; nothing: stays as it is
  std::optional<TargetShape> shape;  ///< nothing: stays as it is
};

/// What clicks in a recording teach.
struct FootageLesson {
  Project project;        ///< with the color that was learned
  std::size_t target = 0; ///< that was taught, an index of its targets
  ClickLesson lesson;
  cv::Mat image; ///< in which the first click is
};

/// Learns the color of a target from clicks in a recording: one that the project has, or a new one
/// of that name. The other cameras are searched for what the first click shows. BadValue names
/// "camera" when the cameras are live, "frame" beyond the end, "pixel" or "box" outside the image;
/// MissingKey names "target" when there are several and none is named; and errors of
/// learnFromClicks(), checkProject() and the source. `emptyRooms` as of loadEmptyRooms().
Result<FootageLesson> learnFromFootage(Project project, FrameSetSource& source,
                                       const std::vector<cv::Mat>& emptyRooms,
                                       FootageClicks clicks);

} // namespace dewpoint::setup
