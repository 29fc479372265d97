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

/// Whether a camera confirms a target, and if not, why.
enum class CameraStatus {
  None,         ///< it does: it sees the target's color where the target is estimated to be
  NoImage,      ///< the camera delivered nothing
  Covered,      ///< hardly anything agrees with the background: covered, moved or blind
  Dark,         ///< the image is too dark to tell colors
  OutOfView,    ///< the expected position lies outside the image
  PartlyHidden, ///< something else covers a part of the target, of which the rest is seen
  Hidden,       ///< something else is seen where the target is expected
  Distractor,   ///< a similar object is `pixels` beside the expected position
  NoColor,      ///< no pixel of the image has the target's color
  Elsewhere, ///< the nearest pixel of the target's color is `pixels` beside the expected position
  Unclear,   ///< its color is seen, but nothing of the target's shape and size
};

/// The report of one camera on a target.
struct CameraReport {
  CameraStatus status = CameraStatus::None;
  double pixels = 0.0; ///< gap between the outlines, or to the color; 0 when they touch
};

/// The reports as one English sentence: "camera left: hidden; camera right: 3 px beside a
/// look-alike". Empty when all cameras confirm the target. A camera without a name is called by its
/// number, from 1 on.
std::string reasonSentence(const std::vector<CameraReport>& reports,
                           const std::vector<std::string>& cameraNames);

/// Whether an image (CV_8UC3) is too dark to tell colors: at most two pixels in a thousand, of a
/// coarse grid, are brighter than 24 of 255 in any channel.
bool isDark(const cv::Mat& image);

/// Distance in pixels from a point to the nearest nonzero pixel of a mask (CV_8UC1).
std::optional<double> distanceToNearest(const cv::Mat& mask, const Eigen::Vector2d& point);

} // namespace dewpoint::tracking
