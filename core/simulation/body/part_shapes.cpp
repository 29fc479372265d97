// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/body/part_shapes.h"

#include <Eigen/Geometry>

namespace dewpoint::simulation {
namespace {

/// Rows: axes of which the third is `along` (a unit vector).
Eigen::Matrix3f axesAlong(const Eigen::Vector3d& along) {
  const Eigen::Vector3d side = along.unitOrthogonal();
  Eigen::Matrix3f axes;
  axes.row(0) = side.cast<float>();
  axes.row(1) = along.cross(side).cast<float>();
  axes.row(2) = along.cast<float>();
  return axes;
}

MovingPart between(MovingShape shape, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                   const Vector3f& color) {
  const Eigen::Vector3d way = to - from;
  const double length = way.norm();
  MovingPart part;
  part.shape = shape;
  part.center = (0.5 * (from + to)).cast<float>();
  part.size.z() = static_cast<float>(0.5 * length);
  if (length > 0.0) {
    part.axes = axesAlong(way / length);
  }
  part.color = color;
  return part;
}

} // namespace

MovingPart capsuleBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
                          const Vector3f& color) {
  MovingPart part = between(MovingShape::Capsule, from, to, color);
  part.size.x() = static_cast<float>(radius);
  part.size.y() = part.size.x();
  return part;
}

MovingPart frustumBetween(const Eigen::Vector3d& from, double fromRadius, const Eigen::Vector3d& to,
                          double toRadius, const Vector3f& color) {
  MovingPart part = between(MovingShape::Frustum, from, to, color);
  part.size.x() = static_cast<float>(fromRadius);
  part.size.y() = static_cast<float>(toRadius);
  return part;
}

MovingPart ellipsoidAt(const Eigen::Vector3d& center, const Eigen::Vector3d& semiAxes,
                       const Vector3f& color) {
  MovingPart part;
  part.center = center.cast<float>();
  part.size = semiAxes.cast<float>();
  part.color = color;
  return part;
}

MovingPart ballPart(double radius, const Vector3f& color) {
  MovingPart part = ellipsoidAt(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(radius), color);
  part.gloss = kBallGloss;
  return part;
}

MovingPart movedPart(MovingPart part, const Eigen::Matrix3d& rotation,
                     const Eigen::Vector3d& shift) {
  part.center = (rotation * part.center.cast<double>() + shift).cast<float>();
  part.axes = part.axes * rotation.transpose().cast<float>();
  return part;
}

} // namespace dewpoint::simulation
