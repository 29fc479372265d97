// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/error_statistics.h"

#include "core/base/statistics.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::trajectory {

double rootMeanSquare(const std::vector<Eigen::Vector3d>& errors) {
  double sum = 0.0;
  for (const Eigen::Vector3d& error : errors)
    sum += error.squaredNorm();
  return std::sqrt(sum / static_cast<double>(errors.size()));
}

ErrorSummary summarize(const std::vector<Eigen::Vector3d>& errors) {
  ErrorSummary summary;
  std::vector<double> lengths;
  for (const Eigen::Vector3d& error : errors) {
    lengths.push_back(error.norm());
    summary.bias += error / static_cast<double>(errors.size());
  }
  std::sort(lengths.begin(), lengths.end());
  summary.rmse = rootMeanSquare(errors);
  summary.medianError = quantile(lengths, 0.5);
  summary.p95 = quantile(lengths, 0.95);
  summary.maxError = lengths.back();
  return summary;
}

CameraBias computeCameraBias(const TrajectoryCamera& camera,
                             const std::vector<Eigen::Vector3d>& errors) {
  const Eigen::Vector3d axis = camera.opticalAxis.normalized();
  std::vector<Eigen::Vector3d> along;
  std::vector<Eigen::Vector3d> across;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& error : errors) {
    along.emplace_back(error.dot(axis) * axis);
    across.emplace_back(error - along.back());
    mean += error / static_cast<double>(errors.size());
  }
  CameraBias bias;
  bias.cameraName = camera.name;
  bias.alongAxisBias = mean.dot(axis);
  bias.acrossAxisBias = (mean - mean.dot(axis) * axis).norm();
  bias.alongAxisRms = rootMeanSquare(along);
  bias.acrossAxisRms = rootMeanSquare(across);
  return bias;
}

} // namespace dewpoint::trajectory
