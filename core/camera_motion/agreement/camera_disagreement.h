// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace dewpoint::camera_motion {

/// Reason why cameras disagree about the positions of objects.
enum class CameraFault {
  Swapped,  ///< the images of two cameras are exchanged
  Late,     ///< the images of one camera are delayed
  Rotated,  ///< one camera does not point in the direction given by its calibration
  Unit,     ///< the positions of all cameras are in a unit other than meters
  SamePose, ///< two cameras have the same position and the same optical axis
  Unknown,  ///< none of the faults above explains the disagreement
};

/// Fault of a rig: the most likely reason why its cameras disagree, and the correction.
struct CameraDisagreement {
  CameraFault fault = CameraFault::Unknown;
  /// Affected cameras. Swapped: the two cameras, or four cameras if either of two pairs may be
  /// swapped. SamePose: both cameras. Late: the delayed camera. Rotated: the rotated camera, or two
  /// cameras if either may be rotated. Unit: no camera. Unknown: the camera that disagrees most, or
  /// both cameras of a two-camera rig.
  std::vector<std::size_t> cameras = {};
  /// For Late: delay in addition to the known delay, seconds; negative if the images are early.
  double delay = 0.0;
  /// For Rotated: the correction for each of `cameras`, as a rotation vector (radians, camera
  /// axes). The corrected cameraFromWorld is exp([turn]x) times the old cameraFromWorld, where
  /// [turn]x is the cross-product matrix of the rotation vector.
  std::vector<Eigen::Vector3d> rotationCorrections = {};
  double metersPerUnit = 1.0; ///< for Unit: meters per unit of the calibration
  /// Log odds (natural logarithm) of this fault against no fault; 0 for Unit and SamePose, which
  /// are certain when they are found.
  double logOdds = 0.0;

  /// Returns whether this fault and `other` are of the same kind and affect the same cameras.
  /// Delays, rotations and other numbers may differ.
  bool isSameAs(const CameraDisagreement& other) const {
    return fault == other.fault && cameras == other.cameras;
  }
};

} // namespace dewpoint::camera_motion
