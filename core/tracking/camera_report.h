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
  Covered,      ///< hardly any pixel agrees with the background: covered, moved or blind
  Dark,         ///< the image is too dark to distinguish colors
  OutOfView,    ///< the expected position lies outside the image
  PartlyHidden, ///< another object covers a part of the target; the rest is visible
  Hidden,       ///< another object is visible where the target is expected
  Distractor,   ///< a similar object is visible, `pixels` away from the expected position
  NoColor,      ///< no pixel of the image has the target's color
  /// The nearest pixel of the target's color is `pixels` away from the expected position.
  Elsewhere,
  Unclear, ///< the target's color is visible, but not its shape and size
};

/// One camera's report on a target.
struct CameraReport {
  CameraStatus status = CameraStatus::None;
  /// Distance in pixels; 0 if the two touch. For Distractor, it is the distance between the outline
  /// of the other object and the expected outline; for Elsewhere, the distance to the nearest pixel
  /// of the color.
  double pixels = 0.0;
};

/// Returns one English sentence that gives the reason for each camera that does not confirm the
/// target, for example "camera left: hidden". Empty if all cameras confirm it. A camera without a
/// name is identified by its number, from 1.
std::string describeReasons(const std::vector<CameraReport>& reports,
                            const std::vector<std::string>& cameraNames);

/// Returns whether an image (CV_8UC3) is too dark to distinguish colors: on a coarse grid, at most
/// two pixels in a thousand are brighter than 24 of 255 in any channel.
bool isDark(const cv::Mat& image);

/// Returns the distance in pixels from a point to the nearest nonzero pixel of a mask (CV_8UC1);
/// nothing if there is none.
std::optional<double> distanceToNearest(const cv::Mat& mask, const Eigen::Vector2d& point);

} // namespace dewpoint::tracking
