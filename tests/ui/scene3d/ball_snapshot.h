// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <QImage>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>

namespace dewpoint::tests {

inline const Eigen::Vector3d kBall(0.5, -0.3, 1.1);

/// A camera at `position` that looks at `target`; built here, so that the test needs no other code.
inline Camera cameraAt(const std::string& name, const Eigen::Vector3d& position,
                       const Eigen::Vector3d& target) {
  Camera camera;
  camera.name = name;
  camera.intrinsics = {640, 480, 560.0, 560.0, 319.5, 239.5};
  const Eigen::Vector3d forward = (target - position).normalized();
  const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  Eigen::Matrix3d rotation;
  rotation << right.transpose(), forward.cross(right).transpose(), forward.transpose();
  camera.cameraFromWorld.linear() = rotation;
  camera.cameraFromWorld.translation() = -rotation * position;
  return camera;
}

/// Three cameras around a ball; a cloud of 400 particles with sigma 0.08 m about it.
inline std::shared_ptr<TrackSnapshot> ballSnapshot(const Eigen::Vector3d& ball = kBall) {
  auto snapshot = std::make_shared<TrackSnapshot>();
  const Eigen::Vector3d target(0.0, 0.0, 0.9);
  snapshot->rig = std::make_shared<CameraRig>(CameraRig{
      cameraAt("north", {0.4, 2.2, 2.0}, target), cameraAt("east", {2.0, -1.0, 1.6}, target),
      cameraAt("west", {-2.1, -1.4, 1.8}, target)});
  TargetSnapshot shown;
  shown.target.name = "ball";
  shown.target.radius = 0.04;
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.0, 0.08);
  constexpr int kCount = 400;
  shown.particles.resize(kCount, 3);
  shown.weights.resize(kCount);
  for (int i = 0; i < kCount; ++i) {
    const Eigen::Vector3d offset(normal(random), normal(random), normal(random));
    shown.particles.row(i) = (ball + offset).transpose().array();
    shown.weights[i] = std::exp(-offset.squaredNorm() / 0.01);
  }
  std::get<SphereEstimate>(shown.estimate).mean = ball;
  std::get<SphereEstimate>(shown.estimate).best = ball;
  std::get<SphereEstimate>(shown.estimate).covariance =
      Eigen::Vector3d(0.0064, 0.0064, 0.0025).asDiagonal();
  std::get<SphereEstimate>(shown.estimate).particleCount = kCount;
  std::get<SphereEstimate>(shown.estimate).isValid = true;
  for (int i = 0; i < 40; ++i) {
    const double back = 0.03 * (39 - i);
    shown.tailPositions.emplace_back(ball.x() - back, ball.y() + 0.4 * std::sin(1.5 * back),
                                     ball.z() - 0.2 * back);
  }
  shown.truth = ball + Eigen::Vector3d(0.02, 0.01, -0.01);
  snapshot->targets.push_back(shown);
  return snapshot;
}

/// Replaces the particles of a target by 300 particles around the ball. `sigma`: their standard
/// deviation along each axis, meters.
inline void scatter(TargetSnapshot& target, double sigma) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, sigma);
  target.particles.resize(300, 3);
  target.weights.setOnes(300);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d offset(normal(random), normal(random), normal(random));
    target.particles.row(i) = (kBall + offset).transpose().array();
  }
  std::get<SphereEstimate>(target.estimate).covariance =
      sigma * sigma * Eigen::Matrix3d::Identity();
}

/// Vermillion of Okabe and Ito (213, 94, 0), the first target's color, at any lightness.
inline bool isTargetColor(QRgb pixel) {
  const int red = qRed(pixel);
  return red > 120 && red - qBlue(pixel) > 60 && red - qGreen(pixel) > 40;
}

/// Mean position and number of the pixels with the target's color within `reach` of `around`.
struct Blob {
  QPointF center;
  int count = 0;
};
inline Blob blob(const QImage& picture, QPointF around, double reach) {
  Blob result;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const bool near = std::hypot(x + 0.5 - around.x(), y + 0.5 - around.y()) < reach;
      if (near && isTargetColor(picture.pixel(x, y))) {
        result.center += QPointF(x + 0.5, y + 0.5);
        ++result.count;
      }
    }
  }
  result.center /= std::max(1, result.count);
  return result;
}

} // namespace dewpoint::tests
