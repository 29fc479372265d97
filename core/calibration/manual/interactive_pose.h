// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/reference_grid.h"

#include <Eigen/Core>

namespace dewpoint::calibration {

/// Along and about whose axes a camera is nudged.
enum class NudgeFrame {
  Camera, ///< x right, y down, z forward
  World   ///< as the project's: z up
};

/// Moved by a distance in meters.
Camera moved(const Camera& camera, const Eigen::Vector3d& meters, NudgeFrame frame);
/// Rotated about its own center: a rotation vector, radians.
Camera rotated(const Camera& camera, const Eigen::Vector3d& rotation, NudgeFrame frame);
/// Focal lengths times this factor.
Camera zoomed(const Camera& camera, double factor);

/// Where a camera looks, as angles in radians: `yaw` from x towards y, `pitch` above the horizon,
/// `roll` about the optical axis, clockwise as the camera sees it (its picture turns the other
/// way).
struct Heading {
  double yaw = 0.0;
  double pitch = 0.0;
  double roll = 0.0;
};
/// Yaw within -pi to pi; straight up or down, roll is 0 and yaw says it all.
Heading headingOf(const Camera& camera);
Camera withHeading(const Camera& camera, const Heading& heading);

/// The same camera with its center elsewhere (world, meters), looking the same way.
Camera withPosition(const Camera& camera, const Eigen::Vector3d& position);

/// Where the optical axis meets the horizontal plane at `height` (meters), if it does so in front
/// of the camera within 100 m; else the point 1 m in front.
Eigen::Vector3d lookedAt(const Camera& camera, double height);
/// Looking at this point from where it stands, with the same roll. A target at the center of the
/// camera leaves it as it is.
Camera lookingAt(const Camera& camera, const Eigen::Vector3d& target);

/// The initial floor grid: around the point that the cameras are directed at, its lines on round
/// numbers of the world, at distances that suit that of the cameras. The standard grid for an empty
/// rig.
ReferenceGrid gridFor(const CameraRig& rig);

/// Horizontal field of view, radians, of the lens without its distortion: 2 atan(w / 2f), or w / f
/// for a fisheye.
double fieldOfView(const Camera& camera);
/// The focal length (pixels, horizontal) that has this field of view.
double focalLengthOf(const Camera& camera, double fieldOfView);
/// With another horizontal focal length, pixels; the vertical one keeps its ratio to it.
Camera withFocalLength(const Camera& camera, double focalX);

} // namespace dewpoint::calibration
