// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/region/ellipsoid_fit.h"

#include "core/geometry/small_matrices.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace dewpoint::observation {
namespace {

// Judgments (docs/method-dewpoint.md, section 12).

/// Pixels, standard deviation of a region's centroid by noise.
constexpr double kCentroidSigmaPx = 0.5;
/// The same as a share of the standard deviation of its area: the raster and the color's noise.
constexpr double kNoiseShare = 0.03;
/// By how many standard deviations of its area the centroid is uncertain for what is missing: half
/// of a disc has its own off by 0.85.
constexpr double kMissingShare = 1.7;
/// Standard deviation of a region's second moments, as a share of their trace.
constexpr double kMomentSigma = 0.1;
/// Share of an outline that must be visible, and of a region's rim that nothing may end, for its
/// second moments to count.
constexpr double kWhole = 0.9;
constexpr double kMostOpen = 0.25;
constexpr int kFitSteps = 3;
constexpr int kFitRounds = 2;
/// Meters and share of the largest, least semi-axis.
constexpr double kLeastAxis = 0.002;
constexpr double kLeastAxisShare = 0.03;
constexpr double kFitJacobianStep = 1e-5; ///< meters

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// The places of the six different elements of a symmetric matrix.
constexpr std::array<std::pair<int, int>, 6> kElements{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

Ellipsoid movedBy(const Ellipsoid& ellipsoid, const Eigen::Vector3d& offset) {
  return {ellipsoid.center + offset, ellipsoid.extent};
}

/// Pixels per meter that the outline moves with the center.
std::optional<Eigen::Matrix<double, 2, 3>>
jacobian(const EllipsoidProjector& projector, const Ellipsoid& here, const EllipseImage& image) {
  Eigen::Matrix<double, 2, 3> j;
  for (int axis = 0; axis < 3; ++axis) {
    const auto there =
        projector.project(movedBy(here, kFitJacobianStep * Eigen::Vector3d::Unit(axis)));
    if (!there) {
      return std::nullopt;
    }
    j.col(axis) = (there->center - image.center) / kFitJacobianStep;
  }
  return j;
}

/// Covariance (px²) of the center by one region, whose centroid is off by `share` of its area's
/// standard deviations.
Eigen::Matrix2d centerNoise(const RegionMeasurement& measurement, const EllipseImage& image,
                            double share) {
  const double missing = kMissingShare * measurement.missingShare();
  const Eigen::Matrix2d area = 0.25 * image.extent;
  return kCentroidSigmaPx * kCentroidSigmaPx * Eigen::Matrix2d::Identity() +
         (share * share + missing * missing) * area;
}

bool isWhole(const RegionMeasurement& measurement) {
  return measurement.region && measurement.visibleShare >= kWhole &&
         measurement.region->cutOffShare() <= kMostOpen;
}

/// Keeps the semi-axes positive.
Eigen::Matrix3d asExtent(const Eigen::Matrix3d& matrix) {
  const auto axes = geometry::symmetricEigen3(0.5 * (matrix + matrix.transpose()));
  const double largest = std::sqrt(std::max(0.0, axes.values.maxCoeff()));
  const double least = std::max(kLeastAxis, kLeastAxisShare * largest);
  return axes.vectors * axes.values.cwiseMax(least * least).asDiagonal() * axes.vectors.transpose();
}

void measureAll(RegionObservation& observation, const EllipsoidPrior& prior,
                const Ellipsoid& expected, const Eigen::Matrix3d& covariance,
                std::vector<RegionMeasurement>& views) {
  views.assign(observation.cameraCount(), {});
  for (std::size_t k = 0; k < views.size(); ++k) {
    auto& view = observation.views()[k];
    const Ellipsoid here = movedBy(expected, view.timeOffset * prior.velocity);
    const auto image = view.projector.project(here);
    const auto j = image ? jacobian(view.projector, here, *image) : std::nullopt;
    if (!view.labels.empty() && j) {
      views[k] = measureRegion(view.labels, *image, *j * covariance * j->transpose());
    }
  }
}

/// One step of Gauss-Newton for the center, and what is known after it.
bool moveCenter(const RegionObservation& observation, const EllipsoidPrior& prior,
                EllipsoidFit& fit) {
  fit.information.setZero();
  Eigen::Vector3d vector = prior.information * (prior.ellipsoid.center - fit.ellipsoid.center);
  fit.seeingCameraCount = 0;
  for (std::size_t k = 0; k < fit.views.size(); ++k) {
    const auto& view = observation.views()[k];
    const RegionMeasurement& measurement = fit.views[k];
    const Ellipsoid here = movedBy(fit.ellipsoid, view.timeOffset * prior.velocity);
    const auto image = measurement.region ? view.projector.project(here) : std::nullopt;
    const auto j = image ? jacobian(view.projector, here, *image) : std::nullopt;
    if (!j) {
      continue;
    }
    const Eigen::Matrix2d weight = centerNoise(measurement, *image, kNoiseShare).inverse();
    fit.information += j->transpose() * weight * *j;
    vector += j->transpose() * weight * (measurement.center() - image->center);
    ++fit.seeingCameraCount;
  }
  const Eigen::LDLT<Eigen::Matrix3d> solver(fit.information + prior.information);
  const Eigen::Vector3d step = solver.solve(vector);
  fit.isFound = fit.seeingCameraCount > 0 && solver.isPositive() && step.allFinite();
  if (fit.isFound) {
    fit.ellipsoid.center += step;
    fit.covariance = (fit.information + prior.information).inverse();
    fit.isFound = fit.covariance.allFinite();
  }
  return fit.isFound;
}

void compareViews(const RegionObservation& observation, const EllipsoidPrior& prior,
                  EllipsoidFit& fit) {
  fit.disagreement = 0.0;
  for (std::size_t k = 0; k < fit.views.size(); ++k) {
    const auto& view = observation.views()[k];
    const auto image =
        fit.views[k].region
            ? view.projector.project(movedBy(fit.ellipsoid, view.timeOffset * prior.velocity))
            : std::nullopt;
    if (image) {
      const Eigen::Vector2d off = fit.views[k].center() - image->center;
      fit.disagreement += off.dot(centerNoise(fit.views[k], *image, kShapeShare).inverse() * off);
    }
  }
  fit.degreesOfFreedom = fit.seeingCameraCount > 1 ? 2 * fit.seeingCameraCount - 3 : 0;
}

} // namespace

Eigen::Matrix3d fitExtent(const RegionObservation& observation,
                          const std::vector<RegionMeasurement>& views, const Ellipsoid& before,
                          const EllipsoidPrior& prior) {
  const Eigen::Matrix3d& known = prior.ellipsoid.extent;
  const double scale = std::max(known.trace(), 3.0 * kLeastAxis * kLeastAxis);
  const double priorWeight = 1.0 / std::pow(prior.extentSigma * scale, 2);
  Matrix6 matrix = Matrix6::Zero();
  Vector6 vector = Vector6::Zero();
  for (int e = 0; e < 6; ++e) {
    const auto [row, column] = kElements[static_cast<std::size_t>(e)];
    // Elements off the diagonal stand for two.
    const double weight = (row == column ? 1.0 : 2.0) * priorWeight;
    matrix(e, e) += weight;
    vector[e] += weight * (known(row, column) - before.extent(row, column));
  }
  const double step = 1e-5 * scale; // the outline is linear in it
  bool any = false;
  for (std::size_t k = 0; k < views.size(); ++k) {
    const auto& view = observation.views()[k];
    const Ellipsoid here = movedBy(before, view.timeOffset * prior.velocity);
    const auto image = isWhole(views[k]) ? view.projector.project(here) : std::nullopt;
    if (!image) {
      continue;
    }
    const Eigen::Matrix2d seen = 4.0 * views[k].region->covariance;
    const Eigen::Matrix2d off = seen - image->extent;
    Eigen::Matrix<double, 3, 6> j = Eigen::Matrix<double, 3, 6>::Zero();
    bool usable = true;
    for (int e = 0; e < 6 && usable; ++e) {
      const auto [row, column] = kElements[static_cast<std::size_t>(e)];
      Ellipsoid other = here;
      other.extent(row, column) += step;
      if (row != column) {
        other.extent(column, row) += step;
      }
      const auto changed = view.projector.project(other);
      usable = changed.has_value();
      if (usable) {
        const Eigen::Matrix2d change = (changed->extent - image->extent) / step;
        j.col(e) << change(0, 0), change(1, 1), change(0, 1);
      }
    }
    if (!usable) {
      continue;
    }
    any = true;
    const double weight = 1.0 / std::pow(kMomentSigma * std::max(seen.trace(), 1.0), 2);
    const Eigen::Vector3d weights(weight, weight, 2.0 * weight);
    matrix += j.transpose() * weights.asDiagonal() * j;
    vector +=
        j.transpose() * weights.asDiagonal() * Eigen::Vector3d(off(0, 0), off(1, 1), off(0, 1));
  }
  const Vector6 change = matrix.ldlt().solve(vector);
  if (!any || !change.allFinite()) {
    return before.extent;
  }
  Eigen::Matrix3d result = before.extent;
  for (int e = 0; e < 6; ++e) {
    const auto [row, column] = kElements[static_cast<std::size_t>(e)];
    result(row, column) += change[e];
    result(column, row) = result(row, column);
  }
  return asExtent(result);
}

EllipsoidFit fitEllipsoid(RegionObservation& observation, const EllipsoidPrior& prior) {
  EllipsoidFit fit;
  fit.ellipsoid = prior.ellipsoid;
  Eigen::Matrix3d covariance = prior.information.inverse();
  if (!covariance.allFinite()) {
    covariance.setZero();
  }
  for (int round = 0; round < kFitRounds; ++round) {
    // What hides the target, and what belongs to it, is clearer where it was found.
    measureAll(observation, prior, fit.ellipsoid, covariance, fit.views);
    for (int step = 0; step < kFitSteps; ++step) {
      if (!moveCenter(observation, prior, fit)) {
        return fit;
      }
      fit.ellipsoid.extent = fitExtent(observation, fit.views, fit.ellipsoid, prior);
    }
    covariance = fit.covariance;
  }
  compareViews(observation, prior, fit);
  return fit;
}

} // namespace dewpoint::observation
