// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace cv {
class Mat;
}

namespace dewpoint::tracking {

/// Why a camera does not confirm a target.
enum class CameraStatus {
  None,         ///< it does: it sees the target's color where the target is believed to be
  NoImage,      ///< the camera delivered nothing
  Covered,      ///< hardly anything in the image is what it usually shows: covered, moved or blind
  Dark,         ///< the image is too dark to tell colors
  OutOfView,    ///< the expected place lies outside the image
  PartlyHidden, ///< something else covers a part of the target, of which the rest is seen
  Hidden,       ///< something else is seen where the target is expected
  Distractor,   ///< something that looks the same is at or beside the expected place; `pixels`
  NoColor,      ///< no pixel of the image has the target's color
  Elsewhere,    ///< the nearest pixel of the target's color is `pixels` beside the expected place
  Unclear,      ///< its color is seen, but nothing of the target's shape and size
};

/// One camera's part in why a target is held or not.
struct CameraReport {
  CameraStatus status = CameraStatus::None;
  double pixels = 0.0; ///< gap between the outlines, or to the color; 0 when they touch
};

/// The reports as one English sentence: "camera left: hidden; camera right: 3 px beside a
/// look-alike". Empty when no camera has any trouble. Names of missing cameras are their numbers.
std::string reasonSentence(const std::vector<CameraReport>& reports,
                           const std::vector<std::string>& cameraNames);

/// Whether the image (CV_8UC3) is too dark to tell colors: hardly a pixel (two in a thousand, of a
/// coarse grid) is brighter than 24 of 255 in any channel.
bool isDark(const cv::Mat& image);

/// Distance in pixels from a point to the nearest nonzero pixel of a mask (CV_8UC1).
std::optional<double> distanceToNearest(const cv::Mat& mask, const Eigen::Vector2d& point);

} // namespace dewpoint::tracking
