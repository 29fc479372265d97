// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/measured_points.h"
#include "core/calibration/manual/pose_change.h"

namespace dewpoint::calibration {

/// The pose of one camera from points (parts of solveFromPoints()).
struct PointPose {
  Camera camera;
  PoseStatus status = PoseStatus::None;
  bool planar = false;
  double rmsPx = 0.0;
};

/// Perspective-n-point without any start, then least squares.
PointPose poseFromPoints(const Camera& camera, const std::vector<ImageAnchor>& anchors,
                         bool alsoFocal);

/// Whether the pictures lie otherwise than they should: `found` is what poseFromPoints() made of
/// them as they are. A mirrored or rotated picture is proposed when it fits while the given one
/// does not; a rotated one also when both fit but only it has the camera upright.
std::optional<SymmetryProposal> betterSymmetry(const Camera& camera,
                                               const std::vector<ImageAnchor>& anchors,
                                               const PointPose& found);

} // namespace dewpoint::calibration
