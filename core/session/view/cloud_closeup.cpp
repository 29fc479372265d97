// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/view/cloud_closeup.h"

#include "core/base/belief_region.h"
#include "core/base/statistics.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::session {

namespace {

constexpr double kFilled = 0.85;      ///< of the picture, at most, by the outline
constexpr double kCloudFilled = 0.45; ///< of the picture, at least, by the particles
/// Of a normal distribution in a plane, 95 % of the mass in space lies within so many times the
/// distance within which half of the points lie.
constexpr double kReachOfHalf = 2.4;
constexpr double kClosest = 0.05;    ///< of the outline's picture: is not enlarged any further
constexpr double kSmallest = 1e-5;   ///< meters from center to border
constexpr double kShareOfBar = 0.55; ///< of the way from center to border, at most

/// The largest of 1, 2 and 5 times a power of ten that is at most `value`.
double roundedDown(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
  const double digit = value / power * (1.0 + 1e-9);
  return power * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
}

/// The smallest of some steps of at most a half each that is at least `value`.
double roundedUpToStep(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double digit : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    if (digit * power >= value * (1.0 - 1e-9)) {
      return digit * power;
    }
  }
  return 10.0 * power;
}

/// Distance from the center within which half of the particles are seen. Few particles far away,
/// which search for the target, do not count.
double halfOfCloud(const TargetSnapshot& target, const Eigen::Matrix<double, 2, 3>& axes,
                   const Eigen::Vector3d& center) {
  std::vector<double> distances;
  for (Eigen::Index k = 0; k < target.particles.rows(); ++k) {
    const Eigen::Vector3d point = target.particles.row(k).head(3).transpose();
    if (const double distance = (axes * (point - center)).norm(); std::isfinite(distance)) {
      distances.push_back(distance);
    }
  }
  return upperMedianInPlace(distances);
}

ImageEllipse projectedOutline(const Eigen::Matrix2d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance);
  const Eigen::Vector2d axes =
      (kChiSquared95ThreeDof * solver.eigenvalues()).cwiseMax(0.0).cwiseSqrt();
  const Eigen::Vector2d major = solver.eigenvectors().col(1);
  return {Eigen::Vector2d::Zero(), axes[1], axes[0], std::atan2(major.y(), major.x())};
}

} // namespace

std::optional<double> cloudSemiAxis(const TargetSnapshot& target) {
  const auto position = positionOf(target.estimate);
  if (!position || !position->mean.allFinite() || !position->covariance.allFinite() ||
      target.particles.cols() < 3 || target.particles.rows() == 0 || target.shape != nullptr) {
    return std::nullopt;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(position->covariance,
                                                              Eigen::EigenvaluesOnly);
  return std::sqrt(kChiSquared95ThreeDof * std::max(0.0, solver.eigenvalues().maxCoeff()));
}

std::optional<CloudCloseup> cloudCloseup(const TargetSnapshot& target, const Eigen::Vector3d& right,
                                         const Eigen::Vector3d& up, double half,
                                         Eigen::Index most) {
  const auto reach = cloudSemiAxis(target);
  if (!reach || half <= 0.0 || most <= 0) {
    return std::nullopt;
  }
  const auto position = positionOf(target.estimate);
  Eigen::Matrix<double, 2, 3> picture;
  picture << right.transpose(), -up.transpose();
  // The ellipsoid contains errors of the calibration, too, and may be much larger than the cloud.
  const double ofOutline = *reach / kFilled;
  const double ofCloud = kReachOfHalf * halfOfCloud(target, picture, position->mean) / kCloudFilled;
  const double border =
      roundedUpToStep(std::max(kSmallest, std::clamp(ofCloud, kClosest * ofOutline, ofOutline)));
  CloudCloseup closeup;
  closeup.metersPerPixel = border / half;
  closeup.scaleBarMeters = roundedDown(kShareOfBar * border);
  picture /= closeup.metersPerPixel;
  closeup.outline = projectedOutline(picture * position->covariance * picture.transpose());

  const Eigen::Index count = target.particles.rows();
  const Eigen::Index stride = (count + most - 1) / most;
  const bool weighted = target.weights.size() == count;
  double largest = 0.0;
  for (Eigen::Index k = 0; weighted && k < count; ++k) {
    largest = std::isfinite(target.weights[k]) ? std::max(largest, target.weights[k]) : largest;
  }
  std::vector<std::pair<float, Eigen::Vector2f>> found;
  for (Eigen::Index k = 0; k < count; k += stride) {
    const Eigen::Vector3d point = target.particles.row(k).head(3).transpose();
    const Eigen::Vector2d pixel = picture * (point - position->mean);
    if (pixel.allFinite() && pixel.cwiseAbs().maxCoeff() <= half) {
      const double share = weighted && largest > 0.0 ? target.weights[k] / largest : 1.0;
      found.emplace_back(std::isfinite(share) ? float(std::clamp(share, 0.0, 1.0)) : 0.0F,
                         pixel.cast<float>());
    }
  }
  std::ranges::stable_sort(found, {}, &std::pair<float, Eigen::Vector2f>::first);
  for (const auto& [weight, pixel] : found) {
    closeup.weights.push_back(weight);
    closeup.particles.push_back(pixel);
  }
  return closeup;
}

} // namespace dewpoint::session
