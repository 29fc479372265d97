// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projector.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// World point (meters) and the pixel at which a camera sees it, or should see it.
struct ImageAnchor {
  Eigen::Vector3d world = Eigen::Vector3d::Zero();
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// Small change of a camera: a rotation about its own x, y and z axes (rotation vector, radians), a
/// displacement along them (in units of CameraVariation's depth), and the logarithm of a zoom
/// factor.
using ChangeVector = Eigen::Matrix<double, 7, 1>;

/// Changes of a camera near its current pose, and their effect on the pixels of points. A change
/// with the rotation R and the displacement `shift` moves a point p in the camera frame to R p +
/// depth * shift.
class CameraVariation {
public:
  /// `depth`: unit of displacements in meters, chosen so that rotations and displacements of equal
  /// size move the image by about the same distance.
  CameraVariation(const Camera& camera, double depth);

  /// Returns the camera after a change.
  Camera changedCamera(const ChangeVector& change) const;
  /// Returns the pixel of a world point after a change, or nothing if the camera does not see it.
  std::optional<Eigen::Vector2d> projectedPixel(const ChangeVector& change,
                                                const Eigen::Vector3d& world) const;
  /// Returns the residuals after a change: the projections of the points minus the given pixels,
  /// two rows per point. Returns nothing if a point is not visible.
  std::optional<Eigen::VectorXd> residuals(const ChangeVector& change,
                                           const std::vector<ImageAnchor>& anchors) const;
  /// Returns the derivatives of the residuals, in pixels per unit of change (central differences).
  std::optional<Eigen::MatrixXd> jacobian(const ChangeVector& change,
                                          const std::vector<ImageAnchor>& anchors) const;

private:
  Eigen::Isometry3d step(const ChangeVector& change) const;

  Camera camera_;
  Projector lens_; ///< lens of the camera, at the world origin
  double depth_;
};

/// Returns the mean distance of the points from the camera, meters; at least 1 cm.
double meanDistance(const Camera& camera, const std::vector<ImageAnchor>& anchors);

/// Returns the root mean square length of the residuals of points. `residuals` contains two rows
/// per point, as from CameraVariation::residuals().
double rmsOfPoints(const Eigen::VectorXd& residuals);

/// Refines the pose of `camera` and, if `estimatesFocal`, its focal length by least squares
/// (Ceres). Returns the root mean square distance in pixels between the given pixels of the points
/// and their projections, or nothing if a point is not visible from the start pose.
std::optional<double> refinePose(Camera& camera, const std::vector<ImageAnchor>& anchors,
                                 bool estimatesFocal);

/// Difference between two poses of a camera.
struct PoseShift {
  double meters = 0.0;  ///< displacement of the optical center, meters
  double radians = 0.0; ///< angle of rotation, radians
};
/// Returns the difference between two poses.
PoseShift poseShift(const Camera& before, const Camera& after);

} // namespace dewpoint::calibration
