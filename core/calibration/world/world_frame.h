// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"
#include "core/geometry/similarity.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

// Changes of the world frame of a calibrated rig: its floor, origin, axes and scale. Each function
// returns the similarity that maps the present world coordinates (meters) to the new ones. The
// cameras keep their positions relative to each other, except for a common scale factor.
namespace dewpoint::calibration {

/// Change of the world frame after which the floor is at z = 0, and how exactly the points of the
/// floor lie in one plane.
struct FloorChange {
  Similarity change;
  double rmsDistance = 0.0; ///< root mean square distance of the points to the plane, meters
};

/// Returns the change of the world frame after which the plane fitted to `points` (least squares)
/// is z = 0. The first point becomes the origin, and the x axis points toward the second one. The
/// cameras determine which side is up: most of them must be above the floor.
///
/// Error: Undetermined (field "floor") if there are fewer than three points, or if they lie on one
/// line.
Result<FloorChange> changeToFloor(const std::vector<Eigen::Vector3d>& points, const CameraRig& rig);

/// Returns the change of the world frame after which the line from `from` to `to` is horizontal.
/// The world is rotated about `from`, by the smallest angle. Error: Undetermined (field "level") if
/// the two points are equal or if the line is closer to vertical than to horizontal.
Result<Similarity> levelingRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Returns the change of the world frame after which `point` is the origin. The axes keep their
/// directions.
Similarity changeToOrigin(const Eigen::Vector3d& point);

/// Returns the rotation of the world about the vertical axis through the origin after which, seen
/// from above, the x axis points in the direction from `from` to `to`. Error: Undetermined (field
/// "axis") if one point is above the other.
Result<Similarity> changeToXAxis(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Returns the change of the world's scale after which the distance between two points is `meters`.
/// The origin stays where it is. Error: BadValue (field "length") unless the length is positive and
/// the points differ.
Result<Similarity> scaleToLength(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                 double meters);

/// Axis of the world frame.
enum class WorldAxis { X, Y, Z };

/// Returns the rotation of the cameras about an axis through the origin by `turns` quarter turns,
/// counterclockwise when the axis points to the viewer.
Similarity quarterTurns(WorldAxis axis, int turns);

/// Returns the rigid motion that moves the cameras by `shift` (meters), after rotating them about
/// the vertical through the origin by `turn` radians, counterclockwise as seen from above.
Similarity rigidMotion(const Eigen::Vector3d& shift, double turn);

/// Returns the rotation, by one or two quarter turns, after which the images are upright, or
/// nothing if they are upright now or if the cameras do not show which way is up. Calibrations of
/// other tools often use the axes of the first camera, or have a z axis that points down.
///
/// The mean of the images' upward directions shows which way is up. Returns nothing if the cameras
/// look steeply down on average, because such cameras may be mounted upside down under a ceiling.
std::optional<Similarity> uprightRotation(const CameraRig& rig);

} // namespace dewpoint::calibration
