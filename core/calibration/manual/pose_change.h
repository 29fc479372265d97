// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projector.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// A world point (meters) and the pixel at which a camera sees it, or should.
struct ImageAnchor {
  Eigen::Vector3d world = Eigen::Vector3d::Zero();
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// A small change of a camera: a turn about its own x, y and z (radians, a rotation vector), a
/// shift along them (in units of PoseChange's depth), and the logarithm of a zoom.
using ChangeVector = Eigen::Matrix<double, 7, 1>;

/// Changes of one camera near its present pose, and where points are seen then. A point at p in the
/// camera's frame comes to R p + depth * shift.
class PoseChange {
public:
  /// `depth`, meters: what a shift is measured by, so that turns and shifts of one size move the
  /// image about as much.
  PoseChange(const Camera& camera, double depth);

  Camera changed(const ChangeVector& change) const;
  /// Pixel of a world point; nothing where the camera does not see it.
  std::optional<Eigen::Vector2d> pixel(const ChangeVector& change,
                                       const Eigen::Vector3d& world) const;
  /// Pixels by which the points are off their positions, two rows each.
  std::optional<Eigen::VectorXd> residuals(const ChangeVector& change,
                                           const std::vector<ImageAnchor>& anchors) const;
  /// Their derivatives, pixels per unit of change (central differences).
  std::optional<Eigen::MatrixXd> jacobian(const ChangeVector& change,
                                          const std::vector<ImageAnchor>& anchors) const;

private:
  Eigen::Isometry3d step(const ChangeVector& change) const;

  Camera camera_;
  Projector lens_; ///< the camera at the world's origin
  double depth_;
};

/// Mean distance of the points from the camera, meters; at least 1 cm.
double meanDistance(const Camera& camera, const std::vector<ImageAnchor>& anchors);

/// Root mean square of the distances in `residuals` (two rows per point).
double rmsOfPoints(const Eigen::VectorXd& residuals);

/// Least squares (Ceres) over pose and, if `alsoFocal`, a zoom: moves `camera`
/// and returns the root mean square distance in pixels; nothing when a point cannot be seen from
/// where it starts.
std::optional<double> refinePose(Camera& camera, const std::vector<ImageAnchor>& anchors,
                                 bool alsoFocal);

/// How far a camera is from where it was.
struct PoseShift {
  double meters = 0.0;  ///< of its optical center
  double radians = 0.0; ///< of its turn
};
PoseShift poseShift(const Camera& before, const Camera& after);

} // namespace dewpoint::calibration
