// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace dewpoint::camera_motion {

/// Why cameras cannot agree on where things are.
enum class CameraFault {
  Swapped,  ///< each shows what the other is calibrated for
  Late,     ///< the images of one show what was some time before
  Rotated,  ///< one does not look where its calibration says
  Unit,     ///< the positions of all cameras are in another unit than meters
  SamePose, ///< two are said to stand at one position, and to look along one axis
  Unknown,  ///< none of these explains it
};

/// A fault of a rig, with the likeliest reason and what mends it.
struct CameraDisagreement {
  CameraFault fault = CameraFault::Unknown;
  /// The cameras concerned: both that are swapped, or two such pairs one of which is; both that
  /// have one pose; the one that is late or rotated, or two one of which is rotated; none for Unit;
  /// of Unknown the one that disagrees most, or both of a rig of two.
  std::vector<std::size_t> cameras = {};
  double delay = 0.0; ///< of Late: seconds, beyond what is known; negative: early
  /// Of Rotated, for each of `cameras`, what mends it: the new cameraFromWorld is exp([turn]x)
  /// times the old one; radians, camera axes.
  std::vector<Eigen::Vector3d> turns = {};
  double scale = 1.0; ///< of Unit: meters of one unit of the calibration
  /// By how much more likely this is than that nothing is wrong, natural logarithm; 0 where it is
  /// certain.
  double logOdds = 0.0;

  /// Whether both say the same of the same cameras, whatever the numbers.
  bool isSameAs(const CameraDisagreement& other) const {
    return fault == other.fault && cameras == other.cameras;
  }
};

} // namespace dewpoint::camera_motion
