// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/similarity.h"

#include "core/geometry/small_matrices.h"

#include <Eigen/Geometry>

namespace dewpoint::geometry {

Similarity fitSimilarity(const std::vector<Eigen::Vector3d>& from,
                         const std::vector<Eigen::Vector3d>& to, bool scaleFree) {
  const Eigen::Matrix4d fitted = closestSimilarity(from, to, scaleFree);
  Similarity change;
  change.scale = scaleFree ? fitted.col(0).head<3>().norm() : 1.0;
  change.rotation = fitted.topLeftCorner<3, 3>() / change.scale;
  change.translation = fitted.topRightCorner<3, 1>();
  return change;
}

Camera transformed(const Similarity& change, Camera camera) {
  const Eigen::Vector3d center = change * camera.center();
  // Normalized, so that many changes one after another do not add up to a shear.
  const Eigen::Quaterniond rotation(
      Eigen::Matrix3d(camera.cameraFromWorld.linear() * change.rotation.transpose()));
  camera.cameraFromWorld.linear() = rotation.normalized().toRotationMatrix();
  camera.cameraFromWorld.translation() = -camera.cameraFromWorld.linear() * center;
  return camera;
}

} // namespace dewpoint::geometry
