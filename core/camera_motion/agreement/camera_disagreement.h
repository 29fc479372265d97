// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace dewpoint::camera_motion {

/// Reason why cameras disagree about the positions of objects.
enum class CameraFault {
  Swapped,  ///< two cameras show what the other one is calibrated for
  Late,     ///< the images of one camera are delayed
  Rotated,  ///< one camera does not look where its calibration says
  Unit,     ///< the positions of all cameras are in a unit other than meters
  SamePose, ///< two cameras have the same position and the same optical axis
  Unknown,  ///< none of these faults explains the disagreement
};

/// A fault of a rig: the most likely reason, and the correction for it.
struct CameraDisagreement {
  CameraFault fault = CameraFault::Unknown;
  /// Cameras concerned. Swapped: both cameras, or two pairs if either may be the swapped one.
  /// SamePose: both cameras. Late and Rotated: the camera, or for Rotated two cameras if either may
  /// be rotated. Unit: none. Unknown: the camera that disagrees most, or both cameras of a rig of
  /// two.
  std::vector<std::size_t> cameras = {};
  double delay = 0.0; ///< for Late: seconds beyond the known delay; negative: early
  /// For Rotated, the correction for each of `cameras`: the new cameraFromWorld is exp([turn]x)
  /// times the old one; radians, camera axes.
  std::vector<Eigen::Vector3d> turns = {};
  double scale = 1.0; ///< for Unit: meters in one unit of the calibration
  /// Log odds (natural logarithm) of this fault against no fault; 0 where it is certain.
  double logOdds = 0.0;

  /// Returns whether both report the same fault of the same cameras, whatever the numbers.
  bool isSameAs(const CameraDisagreement& other) const {
    return fault == other.fault && cameras == other.cameras;
  }
};

} // namespace dewpoint::camera_motion
