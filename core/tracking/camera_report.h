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

/// Status of a target in one camera: confirmed, or the reason why it is not.
enum class CameraStatus {
  None,         ///< confirmed: the target's color is visible at the estimated position
  NoImage,      ///< the camera delivered no image
  Covered,      ///< camera covered, moved or blind: hardly any pixel agrees with the background
  Dark,         ///< the image is too dark to distinguish colors
  OutOfView,    ///< the expected position lies outside the image
  PartlyHidden, ///< another object covers a part of the target; the rest is visible
  Hidden,       ///< another object is visible where the target is expected
  /// A similar object is visible, `outlineDistancePx` pixels away from the expected position.
  Distractor,
  NoColor, ///< no pixel of the image has the target's color
  /// The nearest pixel of the target's color is `outlineDistancePx` pixels away from the expected
  /// position.
  Elsewhere,
  Unclear, ///< the target's color is visible, but not its shape and size
};

/// One camera's report on a target.
struct CameraReport {
  CameraStatus status = CameraStatus::None;
  /// Distance in pixels from the expected outline of the target: for Distractor, to the outline of
  /// the other object; for Elsewhere, to the nearest pixel of the target's color. 0 if the two
  /// touch.
  double outlineDistancePx = 0.0;
};

/// Returns one English sentence that gives the reason for each camera that does not confirm the
/// target, for example "camera left: hidden". Returns an empty text if all cameras confirm the
/// target. A camera without a name is identified by its number, from 1.
std::string describeUnconfirmedCameras(const std::vector<CameraReport>& reports,
                                       const std::vector<std::string>& cameraNames);

/// Returns whether an image (CV_8UC3) is too dark to distinguish colors: on a coarse grid, at most
/// two pixels in a thousand are brighter than 24 of 255 in any channel.
bool isDark(const cv::Mat& image);

/// Returns the distance in pixels from a point to the nearest nonzero pixel of a mask (CV_8UC1), or
/// nothing if all pixels are zero.
std::optional<double> distanceToNearestMaskPixel(const cv::Mat& mask, const Eigen::Vector2d& point);

} // namespace dewpoint::tracking
