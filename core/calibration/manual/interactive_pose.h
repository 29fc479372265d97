// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/reference_grid.h"

#include <Eigen/Core>

namespace dewpoint::calibration {

/// Coordinate frame whose axes are used to move and rotate a camera.
enum class NudgeFrame {
  Camera, ///< x right, y down, z forward
  World   ///< world frame of the project, with z up
};

/// Returns the camera moved by a vector (meters).
Camera moved(const Camera& camera, const Eigen::Vector3d& meters, NudgeFrame frame);
/// Returns the camera rotated about its own center by a rotation vector (radians).
Camera rotated(const Camera& camera, const Eigen::Vector3d& rotation, NudgeFrame frame);
/// Returns the camera with its focal lengths multiplied by a factor.
Camera zoomed(const Camera& camera, double factor);

/// Viewing direction of a camera as angles in radians: `yaw` from x towards y, `pitch` above the
/// horizon, and `roll` about the optical axis. Roll is clockwise as seen by the camera; its image
/// rotates the other way.
struct Heading {
  double yaw = 0.0;
  double pitch = 0.0;
  double roll = 0.0;
};
/// Returns the heading of a camera, with yaw between -pi and pi. If the camera looks straight up or
/// down, roll is 0 and yaw contains the whole rotation.
Heading headingOf(const Camera& camera);
/// Returns the camera rotated to a heading, with its position unchanged.
Camera withHeading(const Camera& camera, const Heading& heading);

/// Returns the camera moved to another position (world, meters) with its orientation unchanged.
Camera withPosition(const Camera& camera, const Eigen::Vector3d& position);

/// Returns the point where the optical axis meets the horizontal plane at `height` (meters), if
/// that point is in front of the camera and within 100 m. Otherwise returns the point 1 m in front
/// of the camera.
Eigen::Vector3d aimPoint(const Camera& camera, double height);
/// Returns the camera rotated towards a point (world, meters), with its position and roll
/// unchanged. A target at the camera's center leaves the camera unchanged.
Camera lookingAt(const Camera& camera, const Eigen::Vector3d& target);

/// Returns an initial floor grid for a rig. It is centered on the point that the cameras look at,
/// with lines at round world coordinates and a spacing that suits the distance of the cameras. For
/// an empty rig, returns the standard grid.
ReferenceGrid referenceGridFor(const CameraRig& rig);

/// Returns the horizontal field of view of the lens without distortion, in radians: 2 atan(w / 2f),
/// or w / f for a fisheye.
double fieldOfView(const Camera& camera);
/// Returns the horizontal focal length (pixels) that gives the camera's lens model a horizontal
/// field of view (radians).
double focalLengthOf(const Camera& camera, double fieldOfView);
/// Returns the camera with another horizontal focal length (pixels). The ratio of the focal lengths
/// is unchanged.
Camera withFocalLength(const Camera& camera, double focalX);

} // namespace dewpoint::calibration
