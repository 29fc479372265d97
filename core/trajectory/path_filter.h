// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace dewpoint::trajectory {

/// How a path is supposed to bend: its derivative of this order (2: the acceleration, 3: the jerk)
/// is white noise of this strength, the same along each axis (Bar-Shalom, Li and Kirubarajan 2001,
/// section 6.2; what a smoother makes of it is a spline of degree 2 order - 1, Wahba 1990).
struct PathModel {
  int order = 2;            ///< 2 to kMostPathOrder
  double strength = 1.0;    ///< spectral density: m² / s^(2 order - 1)
  double noiseFactor = 1.0; ///< by which the covariance of each measured position is multiplied
};
inline constexpr int kMostPathOrder = 5;

/// One instant of a path, and what was seen then.
struct PathPoint {
  double time = 0.0; ///< seconds, ascending
  std::optional<PositionMeasurement> seen;
};

/// A Gaussian of the position at one instant; meters, square meters.
struct PathEstimate {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// The log likelihood of all measured positions, each given those before; squared distances count
/// at most `gate` (standard deviations squared), so that one wrong measurement does not decide. The
/// first five only begin the path.
double pathLogLikelihood(std::span<const PathPoint> path, const PathModel& model, double gate);

/// Squared Mahalanobis distance of each measured position from the prediction out of those before
/// it; those beyond `gate` are not used further. Zero where nothing was seen, and for the first
/// ones.
std::vector<double> pathSurprises(std::span<const PathPoint> path, const PathModel& model,
                                  double gate);

/// The same one after the other: `tell(instant, surprise)` for each instant with a measurement,
/// until it returns false. A search for the first far one need not wait for the end of a long path.
void eachPathSurprise(std::span<const PathPoint> path, const PathModel& model, double gate,
                      const std::function<bool(std::size_t, double)>& tell);

/// The estimate of each instant from all measurements before and after it: the smoother of Rauch,
/// Tung and Striebel (1965). The first instant must have a measurement; instants after the last one
/// are predictions. `goesOn`, when given, is called now and then; after false the estimates mean
/// nothing.
std::vector<PathEstimate> smoothPath(std::span<const PathPoint> path, const PathModel& model,
                                     const std::function<bool()>& goesOn = {});

/// The effect of an error that all measurements share on the smoothed positions, m² at each
/// instant: that of a measurement of covariance C is C^(1/2) u, with the same normal vector u for
/// all. It is not averaged away, and the smoother knows nothing of it (a "consider" parameter;
/// Bierman 1977, chapter VIII). `goesOn` as for smoothPath().
std::vector<Eigen::Matrix3d> sharedErrors(std::span<const PathPoint> path, const PathModel& model,
                                          const std::function<bool()>& goesOn = {});

} // namespace dewpoint::trajectory
