// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_motion/agreement/region_match.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::camera_motion {
namespace {

// Chosen on tuning seeds.
constexpr double kSizeSigma = 0.3;  ///< of the logarithm of the ratio of two sizes
constexpr double kSizeRange = 3.0;  ///< of that logarithm, of unrelated things
constexpr double kSizeUnlike = 0.2; ///< that parts are hidden, and sizes say nothing
constexpr double kParallel = 4.0;   ///< standard deviations: of rays that meet nowhere certain

double normalDensity(double z) {
  return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
}

} // namespace

RegionMatch matchRegions(const SeenRegion& a, const Eigen::Vector3d& u, const SeenRegion& b,
                         const Eigen::Vector3d& v, const Eigen::Vector3d& apart, double widening,
                         double field) {
  RegionMatch match;
  const Eigen::Vector3d along = apart.normalized();
  const Eigen::Vector3d residualByU = v.cross(along);
  const Eigen::Vector3d residualByV = along.cross(u);
  const double value = along.dot(u.cross(v));
  const double leverU =
      std::sqrt(std::max(0.0, residualByU.squaredNorm() - std::pow(residualByU.dot(u), 2)));
  const double leverV =
      std::sqrt(std::max(0.0, residualByV.squaredNorm() - std::pow(residualByV.dot(v), 2)));
  const double sigma =
      std::hypot(std::hypot(a.sigma, widening) * leverU, std::hypot(b.sigma, widening) * leverV);
  if (!(sigma > 0.0)) {
    return match; // both look along the line between the cameras
  }
  match.residual = value / sigma;
  match.residualByU = residualByU / sigma;
  match.residualByV = residualByV / sigma;
  match.relativeLikelihood = normalDensity(match.residual) * field * leverV / sigma;
  const Eigen::Vector3d normal = u.cross(v);
  const double sine = normal.norm();
  if (sine < kParallel * std::hypot(a.sigma, b.sigma, widening)) {
    return match;
  }
  const double depthA = apart.cross(v).dot(normal) / (sine * sine);
  const double depthB = apart.cross(u).dot(normal) / (sine * sine);
  if (depthA <= 0.0 || depthB <= 0.0) {
    match.relativeLikelihood = 0.0;
    return match;
  }
  const double ratio = std::log(a.radius * depthA / (b.radius * depthB));
  match.relativeLikelihood *= kSizeUnlike + (1.0 - kSizeUnlike) * kSizeRange / kSizeSigma *
                                                normalDensity(ratio / kSizeSigma);
  match.objectRadius = 0.5 * (a.radius * depthA + b.radius * depthB);
  return match;
}

} // namespace dewpoint::camera_motion
