// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/target_volume.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>

namespace dewpoint::simulation {
namespace {

TargetVolume ofEllipsoid(const MovingPart& part) {
  // The second moment of a solid ball about its center is a fifth of its squared radius per axis.
  const Eigen::Matrix3d axes = part.axes.cast<double>();
  const Eigen::Vector3d moments = 0.2 * part.size.cast<double>().cwiseAbs2();
  return {volumeOf(part), part.center.cast<double>(),
          axes.transpose() * moments.asDiagonal() * axes};
}

/// The box along the world's axes that holds a part.
Eigen::AlignedBox3d boxAround(const MovingPart& part) {
  const bool round = part.shape == MovingShape::Capsule;
  const Eigen::Vector3d size = part.size.cast<double>();
  const double wide = part.shape == MovingShape::Frustum ? std::max(size.x(), size.y()) : size.x();
  Eigen::Vector3d half = size;
  if (round || part.shape == MovingShape::Frustum) {
    half = {wide, wide, size.z() + (round ? wide : 0.0)};
  }
  const Eigen::Vector3d reach = part.axes.cast<double>().cwiseAbs().transpose() * half;
  const Eigen::Vector3d center = part.center.cast<double>();
  return {center - reach, center + reach};
}

TargetVolume onGrid(const std::vector<MovingPart>& parts) {
  Eigen::AlignedBox3d box;
  for (const MovingPart& part : parts) {
    box.extend(boxAround(part));
  }
  const Eigen::Vector3d cell = box.sizes() / kGridCells;
  double count = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (int x = 0; x < kGridCells; ++x) {
    for (int y = 0; y < kGridCells; ++y) {
      for (int z = 0; z < kGridCells; ++z) {
        const Eigen::Vector3d offset =
            Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5).cwiseProduct(cell);
        const Eigen::Vector3f point = (box.min() + offset).cast<float>();
        if (std::ranges::any_of(parts,
                                [&](const MovingPart& part) { return contains(part, point); })) {
          count += 1.0;
          sum += offset;
          squares += offset * offset.transpose();
        }
      }
    }
  }
  if (count == 0.0) {
    return {};
  }
  const Eigen::Vector3d mean = sum / count;
  return {count * cell.prod(), box.min() + mean, squares / count - mean * mean.transpose()};
}

} // namespace

TargetVolume targetVolume(const std::vector<MovingPart>& parts) {
  std::vector<MovingPart> targets;
  std::ranges::copy_if(parts, std::back_inserter(targets), &MovingPart::target);
  if (targets.empty()) {
    return {};
  }
  if (targets.size() == 1 && targets.front().shape == MovingShape::Ellipsoid) {
    return ofEllipsoid(targets.front());
  }
  return onGrid(targets);
}

} // namespace dewpoint::simulation
