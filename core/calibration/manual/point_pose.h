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

/// Which way up a world is, as far as the pose of a camera tells.
enum class WorldSide {
  Unknown, ///< the points fit badly, or the camera looks steeply down or up
  Upright, ///< no sign that z points down
  Inverted ///< the image is upside down in this world, and all points lie above the camera
};

/// Returns which way up the world is for `found`, the result of poseFromPoints() for these anchors.
/// A camera with an upright image is WorldSide::Inverted where z points down.
WorldSide worldSideOf(const PointPose& found, const std::vector<ImageAnchor>& anchors);

/// Checks whether the images of a camera are rotated or mirrored. `found` is the result of
/// poseFromPoints() for the current images. A mirrored or rotated image is proposed if it fits and
/// the current one does not. A rotated image is also proposed if both fit but the camera is upright
/// only with the rotation.
std::optional<SymmetryProposal> proposeSymmetry(const Camera& camera,
                                                const std::vector<ImageAnchor>& anchors,
                                                const PointPose& found);

} // namespace dewpoint::calibration
