// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/reference_grid.h"

#include <Eigen/Core>

namespace dewpoint::calibration {

/// Frame whose axes a camera is moved along and rotated about.
enum class NudgeFrame {
  Camera, ///< x right, y down, z forward
  World   ///< as in the project: z up
};

/// Returns the camera moved by a vector in meters.
Camera moved(const Camera& camera, const Eigen::Vector3d& meters, NudgeFrame frame);
/// Returns the camera rotated about its own center by a rotation vector, radians.
Camera rotated(const Camera& camera, const Eigen::Vector3d& rotation, NudgeFrame frame);
/// Returns the camera with its focal lengths multiplied by a factor.
Camera zoomed(const Camera& camera, double factor);

/// Viewing direction of a camera as angles in radians: `yaw` from x towards y, `pitch` above the
/// horizon, `roll` about the optical axis, clockwise as the camera sees it (its image rotates the
/// other way).
struct Heading {
  double yaw = 0.0;
  double pitch = 0.0;
  double roll = 0.0;
};
/// Heading of a camera, with yaw within -pi to pi. For a camera that looks straight up or down,
/// roll is 0 and yaw contains the whole rotation.
Heading headingOf(const Camera& camera);
Camera withHeading(const Camera& camera, const Heading& heading);

/// Returns the camera moved to another position (world, meters), with the same orientation.
Camera withPosition(const Camera& camera, const Eigen::Vector3d& position);

/// Point where the optical axis meets the horizontal plane at `height` (meters), if that is in
/// front of the camera and within 100 m; otherwise the point 1 m in front of it.
Eigen::Vector3d lookedAt(const Camera& camera, double height);
/// Returns the camera rotated towards a point (world, meters), with the same position and roll. A
/// target at the center of the camera leaves it unchanged.
Camera lookingAt(const Camera& camera, const Eigen::Vector3d& target);

/// Initial floor grid for a rig: around the point that the cameras look at, with lines at round
/// world coordinates and a spacing that suits the distance of the cameras. The standard grid for an
/// empty rig.
ReferenceGrid gridFor(const CameraRig& rig);

/// Horizontal field of view of the lens without distortion, radians: 2 atan(w / 2f), or w / f for a
/// fisheye.
double fieldOfView(const Camera& camera);
/// Horizontal focal length (pixels) for a field of view (radians).
double focalLengthOf(const Camera& camera, double fieldOfView);
/// Returns the camera with another horizontal focal length, pixels; the ratio of the focal lengths
/// stays the same.
Camera withFocalLength(const Camera& camera, double focalX);

} // namespace dewpoint::calibration
