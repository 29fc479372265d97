// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/error_split.h"

#include <limits>

namespace dewpoint::experiment {
namespace {

/// Shortest mean of unit vectors that still counts as a direction.
constexpr double kShortestMean = 1e-6;

std::optional<TrajectoryCamera> meanView(const std::vector<TrajectoryCamera>& cameras) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const TrajectoryCamera& camera : cameras)
    mean += camera.opticalAxis.normalized() / static_cast<double>(cameras.size());
  if (mean.norm() < kShortestMean)
    return std::nullopt;
  return TrajectoryCamera{"mean view", Eigen::Vector3d::Zero(), mean.normalized()};
}

double spreadAbout(const Eigen::Vector3d& mean, std::vector<Eigen::Vector3d> errors) {
  for (Eigen::Vector3d& error : errors)
    error -= mean;
  return rootMeanSquare(errors);
}

ErrorSplit nothing() {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  ErrorSplit split;
  split.summary = {kNothing, kNothing, kNothing, kNothing, Eigen::Vector3d::Constant(kNothing)};
  split.spread = kNothing;
  return split;
}

} // namespace

ErrorSplit splitErrors(const std::vector<Eigen::Vector3d>& errors,
                       const std::vector<TrajectoryCamera>& cameras) {
  std::vector<Eigen::Vector3d> finite;
  for (const Eigen::Vector3d& error : errors)
    if (error.allFinite())
      finite.push_back(error);
  if (finite.empty())
    return nothing();
  ErrorSplit split;
  split.errorCount = static_cast<std::int64_t>(finite.size());
  split.summary = summarize(finite);
  split.spread = spreadAbout(split.summary.bias, finite);
  if (const auto view = meanView(cameras))
    split.meanViewBias = computeCameraBias(*view, finite);
  for (const TrajectoryCamera& camera : cameras)
    split.cameraBiases.push_back(computeCameraBias(camera, finite));
  return split;
}

} // namespace dewpoint::experiment
