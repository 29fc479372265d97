// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace dewpoint::trajectory {

/// Motion model of a path. The derivative of order `derivativeOrder` (2: acceleration, 3: jerk) is
/// white noise with spectral density `spectralDensity`, the same along each axis (Bar-Shalom, Li
/// and Kirubarajan 2001, section 6.2). The smoothed path is a spline of degree 2 * derivativeOrder
/// - 1 (Wahba 1990).
struct PathModel {
  int derivativeOrder = 2;      ///< order of the derivative that is white noise, 2 to kMaxPathOrder
  double spectralDensity = 1.0; ///< m² / s^(2 * derivativeOrder - 1)
  /// Factor by which the covariance of each measured position is multiplied.
  double noiseFactor = 1.0;
};
/// Largest order of a path model.
inline constexpr int kMaxPathOrder = 5;

/// One time on a path, and the position measured at this time, if any.
struct PathPoint {
  double time = 0.0; ///< seconds, ascending
  std::optional<PositionMeasurement> measurement;
};

/// Gaussian estimate of the position at one point of a path, in meters and square meters.
struct PathEstimate {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// Returns the log likelihood of the measured positions. It is the sum of the log likelihoods of
/// each position given the preceding ones. Squared Mahalanobis distances are limited to `gate`, so
/// that one wrong measurement does not dominate. The first five measurements only initialize the
/// path and are not included.
double pathLogLikelihood(std::span<const PathPoint> path, const PathModel& model, double gate);

/// Returns the squared Mahalanobis distance of each measured position from its prediction by the
/// preceding ones. A measurement whose squared distance exceeds `gate` is not used to predict later
/// ones. The result has one entry per point of the path. The entry is zero for points without a
/// measurement and for the first measurements.
std::vector<double> normalizedInnovations(std::span<const PathPoint> path, const PathModel& model,
                                          double gate);

/// Computes the same distances as normalizedInnovations(), one by one. Calls `onInnovation(index,
/// distance)` for each point with a measurement, where `index` is the index of the point in `path`.
/// Ends when a call returns false, so a search for the first outlier can end early.
void forEachNormalizedInnovation(std::span<const PathPoint> path, const PathModel& model,
                                 double gate,
                                 const std::function<bool(std::size_t, double)>& onInnovation);

/// Returns the estimate at each point of the path. Each estimate is computed from all measurements,
/// earlier and later ones, with the smoother of Rauch, Tung and Striebel (1965). The first point
/// must have a measurement. Estimates after the last measurement are predictions. `shouldContinue`,
/// if given, is called from time to time; after it has returned false, the estimates are not
/// usable.
std::vector<PathEstimate> smoothPath(std::span<const PathPoint> path, const PathModel& model,
                                     const std::function<bool()>& shouldContinue = {});

/// Returns, for each point of the path, the covariance (m²) that an error shared by all
/// measurements adds to the smoothed position. A measurement with covariance C has the error
/// C^(1/2) u, where the random vector u (standard normal) is the same for all measurements. Such an
/// error does not average out. The smoother does not estimate it, but this function computes its
/// effect (a "consider" parameter; Bierman 1977, chapter VIII). `shouldContinue` has the same
/// meaning as in smoothPath().
std::vector<Eigen::Matrix3d>
sharedErrorCovariances(std::span<const PathPoint> path, const PathModel& model,
                       const std::function<bool()>& shouldContinue = {});

} // namespace dewpoint::trajectory
