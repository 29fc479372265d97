// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/camera_variation.h"
#include "core/calibration/manual/measured_points.h"

namespace dewpoint::calibration {

/// Pose of one camera from points; an intermediate result of solveFromPoints().
struct PointPose {
  Camera camera;
  PoseStatus status = PoseStatus::None;
  bool arePointsCoplanar = false;
  double rmsPx = 0.0;
};

/// Estimates the pose of a camera from points and their pixels, by perspective-n-point without a
/// start value and then by least squares. With `estimatesFocal`, also estimates its focal length.
PointPose poseFromPoints(const Camera& camera, const std::vector<ImageAnchor>& anchors,
                         bool estimatesFocal);

/// Direction of the world's z axis, as shown by the pose of one camera.
enum class WorldUprightness {
  Unknown, ///< the points fit badly, or the camera looks steeply down or up
  Upright, ///< no sign that z points down
  /// The image is upside down with respect to this world, and all points lie above the camera.
  Inverted
};

/// Returns whether the z axis of the world points up, as far as one camera shows. Assumes that the
/// images of this camera are upright. `found` is the result of poseFromPoints() for these anchors.
WorldUprightness uprightnessOf(const PointPose& found, const std::vector<ImageAnchor>& anchors);

/// Checks whether the images of a camera are rotated or mirrored. `found` is the result of
/// poseFromPoints() for the current images. A change (a rotation or mirroring of the images) is
/// proposed in three cases:
/// - The clicks fit only with the change.
/// - They fit with and without a rotation, but the camera is upright only with the rotation.
/// - They fit with and without the change, all points lie in a horizontal plane, and the camera is
///   below this plane without the change.
std::optional<SymmetryProposal> proposeSymmetry(const Camera& camera,
                                                const std::vector<ImageAnchor>& anchors,
                                                const PointPose& found);

} // namespace dewpoint::calibration
