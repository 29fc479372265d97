// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/systematic_errors.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace dewpoint::tracking {
namespace {

/// Relative standard deviation of the distance that the size of an outline says. A judgment: blur
/// and shade move an edge by a tenth of the radius (docs/method-dewpoint.md, section 6).
constexpr double kSizeSigma = 0.1;

} // namespace

Eigen::Matrix3d covarianceFromDirectionErrors(const Eigen::Vector3d& position,
                                              const std::vector<Eigen::Vector3d>& cameraCenters,
                                              double sigma) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& center : cameraCenters) {
    const Eigen::Vector3d ray = position - center;
    const double distance = ray.norm();
    const Eigen::Vector3d along = ray / distance;
    const Eigen::Matrix3d depth = along * along.transpose();
    information += (Eigen::Matrix3d::Identity() - depth) / std::pow(distance * sigma, 2) +
                   depth / std::pow(distance * kSizeSigma, 2);
  }
  return information.isZero(0.0) ? Eigen::Matrix3d(Eigen::Matrix3d::Zero())
                                 : Eigen::Matrix3d(information.inverse());
}

Eigen::Matrix3d withSystematicErrors(const Eigen::Matrix3d& known,
                                     const Eigen::Matrix3d& systematic,
                                     const std::optional<Eigen::Matrix3d>& given) {
  if (!given || systematic.isZero(0.0)) {
    return known + systematic;
  }
  const Eigen::Matrix3d byHand = given->inverse();
  // What the images alone say; none in a direction in which they say nothing.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> images(known.inverse() - byHand);
  const Eigen::Matrix3d root = images.eigenvectors() *
                               images.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
                               images.eigenvectors().transpose();
  const Eigen::Matrix3d wider = Eigen::Matrix3d::Identity() + root * systematic * root;
  return (byHand + root * wider.inverse() * root).inverse();
}

double probabilityWithin(const Eigen::Matrix3d& covariance, double radius) {
  // The squared length of a normal vector is approximated by a scaled chi-square variable of the
  // same mean and variance (Satterthwaite 1946), whose cube root is nearly normal (Wilson and
  // Hilferty 1931).
  const double trace = covariance.trace();
  const double degreesOfFreedom = trace * trace / covariance.squaredNorm();
  const double variance = 2.0 / (9.0 * degreesOfFreedom);
  const double off = (std::cbrt(radius * radius / trace) - (1.0 - variance)) / std::sqrt(variance);
  return 0.5 * std::erfc(-off / std::numbers::sqrt2);
}

} // namespace dewpoint::tracking
