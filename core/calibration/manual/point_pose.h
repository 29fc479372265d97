// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/measured_points.h"
#include "core/calibration/manual/pose_change.h"

namespace dewpoint::calibration {

/// Pose of one camera from points; an intermediate result of solveFromPoints().
struct PointPose {
  Camera camera;
  PoseStatus status = PoseStatus::None;
  bool planar = false;
  double rmsPx = 0.0;
};

/// Estimates a pose by perspective-n-point without a start value, followed by least squares.
PointPose poseFromPoints(const Camera& camera, const std::vector<ImageAnchor>& anchors,
                         bool estimateFocal);

/// Checks whether the images of a camera are rotated or mirrored. `found` is the result of
/// poseFromPoints() for the current images. A mirrored or rotated image is proposed if it fits and
/// the current one does not. A rotated image is also proposed if both fit but the camera is upright
/// only with the rotation.
std::optional<SymmetryProposal> proposeSymmetry(const Camera& camera,
                                                const std::vector<ImageAnchor>& anchors,
                                                const PointPose& found);

} // namespace dewpoint::calibration
