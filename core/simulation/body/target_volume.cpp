// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/body/target_volume.h"

#include <algorithm>
#include <iterator>
#include <numbers>

namespace dewpoint::simulation {
namespace {

/// Cells per side of the grid that counts what parts share; chosen: parts share little.
constexpr int kGridCells = 10;

/// Integrals over a solid of 1, x and x x^T.
struct Moments {
  double zeroth = 0.0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  void add(double weight, const Eigen::Vector3d& point) {
    zeroth += weight;
    first += weight * point;
    second += weight * point * point.transpose();
  }
};

/// Of a part around its own center, along its own axes: by symmetry only `firstZ` and the diagonal
/// of the second moments are not 0.
struct OwnMoments {
  double firstZ = 0.0;
  Eigen::Vector3d second = Eigen::Vector3d::Zero();
};

OwnMoments ofCapsule(double radius, double half) {
  constexpr double kPi = std::numbers::pi;
  const double r2 = radius * radius;
  const double balls = 4.0 / 3.0 * kPi * r2 * radius; // its two ends are one ball together
  const double across = 0.5 * kPi * r2 * r2 * half + 0.2 * balls * r2;
  const double along = 2.0 / 3.0 * kPi * r2 * half * half * half + 0.2 * balls * r2 +
                       kPi * r2 * r2 * half + balls * half * half;
  return {0.0, {across, across, along}};
}

OwnMoments ofFrustum(double low, double high, double half) {
  constexpr double kPi = std::numbers::pi;
  // The radius is middle + slope z.
  const double middle = 0.5 * (low + high);
  const double slope = 0.5 * (high - low) / half;
  const double m2 = middle * middle;
  const double s2 = slope * slope;
  const double h3 = half * half * half;
  const double h5 = h3 * half * half;
  const double across =
      0.25 * kPi * (2.0 * m2 * m2 * half + 4.0 * m2 * s2 * h3 + 0.4 * s2 * s2 * h5);
  const double along = kPi * (2.0 / 3.0 * m2 * h3 + 0.4 * s2 * h5);
  return {4.0 / 3.0 * kPi * middle * slope * h3, {across, across, along}};
}

OwnMoments ownMomentsOf(const MovingPart& part) {
  const Eigen::Vector3d size = part.size.cast<double>();
  const Eigen::Vector3d squares = size.cwiseAbs2();
  switch (part.shape) {
  case MovingShape::Ellipsoid:
    return {0.0, volumeOf(part) / 5.0 * squares};
  case MovingShape::Capsule:
    return ofCapsule(size.x(), size.z());
  case MovingShape::Frustum:
    return ofFrustum(size.x(), size.y(), size.z());
  case MovingShape::Box:
    return {0.0, volumeOf(part) / 3.0 * squares};
  }
  return {};
}

Moments momentsOf(const MovingPart& part) {
  const OwnMoments own = ownMomentsOf(part);
  const double volume = volumeOf(part);
  const Eigen::Matrix3d axes = part.axes.cast<double>();
  const Eigen::Vector3d center = part.center.cast<double>();
  const Eigen::Vector3d shift = own.firstZ * axes.row(2).transpose(); // times the volume
  Moments moments;
  moments.zeroth = volume;
  moments.first = volume * center + shift;
  moments.second = axes.transpose() * own.second.asDiagonal() * axes + shift * center.transpose() +
                   center * shift.transpose() + volume * center * center.transpose();
  return moments;
}

/// Half sizes of the box around a part along its own axes.
Eigen::Vector3d halfBoxOf(const MovingPart& part) {
  const Eigen::Vector3d size = part.size.cast<double>();
  if (part.shape == MovingShape::Capsule) {
    return {size.x(), size.x(), size.x() + size.z()};
  }
  if (part.shape == MovingShape::Frustum) {
    const double wide = std::max(size.x(), size.y());
    return {wide, wide, size.z()};
  }
  return size;
}

/// The points of a grid that lie in a part. World frame.
std::vector<Eigen::Vector3d> pointsIn(const MovingPart& part) {
  const Eigen::Vector3d half = halfBoxOf(part);
  const Eigen::Matrix3d worldFromOwn = part.axes.cast<double>().transpose();
  std::vector<Eigen::Vector3d> points;
  for (int cell = 0; cell < kGridCells * kGridCells * kGridCells; ++cell) {
    const int x = cell % kGridCells;
    const int y = cell / kGridCells % kGridCells;
    const int z = cell / (kGridCells * kGridCells);
    const Eigen::Vector3d share =
        (2.0 * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5) / kGridCells).array() - 1.0;
    const Eigen::Vector3d point =
        part.center.cast<double>() + worldFromOwn * share.cwiseProduct(half);
    if (contains(part, point.cast<float>())) {
      points.push_back(point);
    }
  }
  return points;
}

/// Takes away what other parts count as well: of a point in n parts, all but an n-th of each.
void shareOverlap(const std::vector<MovingPart>& parts, std::size_t index, Moments& moments) {
  const std::vector<Eigen::Vector3d> points = pointsIn(parts[index]);
  for (const Eigen::Vector3d& point : points) {
    double holders = 1.0;
    for (std::size_t other = 0; other < parts.size(); ++other) {
      holders += other != index && contains(parts[other], point.cast<float>()) ? 1.0 : 0.0;
    }
    if (holders > 1.0) {
      const double cell = volumeOf(parts[index]) / static_cast<double>(points.size());
      moments.add(-cell * (1.0 - 1.0 / holders), point);
    }
  }
}

} // namespace

TargetVolume targetVolume(const std::vector<MovingPart>& parts) {
  std::vector<MovingPart> targets;
  std::ranges::copy_if(parts, std::back_inserter(targets), &MovingPart::belongsToTarget);
  Moments all;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Moments one = momentsOf(targets[i]);
    all.zeroth += one.zeroth;
    all.first += one.first;
    all.second += one.second;
    if (targets.size() > 1) {
      shareOverlap(targets, i, all);
    }
  }
  if (!(all.zeroth > 0.0)) {
    return {};
  }
  const Eigen::Vector3d centroid = all.first / all.zeroth;
  return {all.zeroth, centroid, all.second / all.zeroth - centroid * centroid.transpose()};
}

} // namespace dewpoint::simulation
