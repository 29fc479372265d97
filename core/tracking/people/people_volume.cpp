// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/people/people_volume.h"

#include "core/base/elementary.h"
#include "core/base/vector_kernel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

namespace dewpoint::tracking {

namespace {

/// Adds what the kernel on one point contributes at all points.
struct GaussianSumKernel {
  DEWPOINT_KERNEL void run(std::int64_t count, const double* __restrict x,
                           const double* __restrict y, const double* __restrict z,
                           std::int64_t center, double scale, double weight,
                           double* __restrict density) {
    const double centerX = x[center];
    const double centerY = y[center];
    const double centerZ = z[center];
    for (std::int64_t i = 0; i < count; ++i) {
      const double dx = x[i] - centerX;
      const double dy = y[i] - centerY;
      const double dz = z[i] - centerZ;
      density[i] += weight * exponential(scale * (dx * dx + dy * dy + dz * dz));
    }
  }
};

} // namespace

Eigen::ArrayXd densityAtPoints(const BodyCloud& body, double sigma) {
  const Eigen::Index count = body.points.rows();
  const double scale = -0.5 / (sigma * sigma);
  const double peak = std::pow(2.0 * std::numbers::pi * sigma * sigma, -1.5);
  Eigen::ArrayXd density = Eigen::ArrayXd::Zero(count);
  for (Eigen::Index center = 0; center < count; ++center) {
    runKernel<GaussianSumKernel>(std::int64_t{count}, body.points.col(0).data(),
                                 body.points.col(1).data(), body.points.col(2).data(),
                                 std::int64_t{center}, scale, peak * body.weights[center],
                                 density.data());
  }
  return density;
}

ConvexHull bodyHull(const BodyCloud& body, double probability, double sigma) {
  const Eigen::ArrayXd density = densityAtPoints(body, sigma);
  std::vector<Eigen::Index> order(static_cast<std::size_t>(density.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::ranges::stable_sort(order,
                           [&](Eigen::Index a, Eigen::Index b) { return density[a] > density[b]; });
  std::vector<Eigen::Vector3d> inside;
  double held = 0.0;
  for (const Eigen::Index i : order) {
    if (held >= probability) {
      break;
    }
    held += body.weights[i];
    inside.emplace_back(body.points.row(i).transpose().matrix());
  }
  return convexHull(inside);
}

GroundGrid groundDensity(const BodyCloud& body, double step, double sigma) {
  GroundGrid grid;
  grid.step = step;
  if (body.points.rows() == 0) {
    return grid;
  }
  const double reach = 3.0 * sigma;
  const Eigen::Array2d low = body.points.leftCols<2>().colwise().minCoeff().transpose() - reach;
  const Eigen::Array2d high = body.points.leftCols<2>().colwise().maxCoeff().transpose() + reach;
  const Eigen::Array2d cells = ((high - low) / step).ceil();
  grid.origin = low;
  grid.values = Eigen::ArrayXXd::Zero(static_cast<Eigen::Index>(cells.x()) + 1,
                                      static_cast<Eigen::Index>(cells.y()) + 1);
  const double peak = 1.0 / (2.0 * std::numbers::pi * sigma * sigma);
  const auto along = [&](double value, Eigen::Index count) -> Eigen::ArrayXd {
    const Eigen::ArrayXd places =
        Eigen::ArrayXd::LinSpaced(count, 0.0, step * static_cast<double>(count - 1));
    return (-0.5 / (sigma * sigma) * (places - value).square()).exp();
  };
  for (Eigen::Index i = 0; i < body.points.rows(); ++i) {
    const Eigen::ArrayXd x = along(body.points(i, 0) - low.x(), grid.values.rows());
    const Eigen::ArrayXd y = along(body.points(i, 1) - low.y(), grid.values.cols());
    grid.values += body.weights[i] * peak * (x.matrix() * y.matrix().transpose()).array();
  }
  return grid;
}

} // namespace dewpoint::tracking
