// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/planning/uncertainty_map.h"

#include "core/geometry/projector.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace dewpoint::calibration {
namespace {

constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();
constexpr double kPointStep = 1e-4; // meters, of the differences
constexpr double kFlattest = 1e-7;  // smallest by largest eigenvalue of the information

/// Pixels of many points, and of the same points moved by a step along each axis.
struct PixelColumns {
  std::vector<double> column, row;

  void project(const Projector& projector, const std::vector<double>& x,
               const std::vector<double>& y, const std::vector<double>& z) {
    column.resize(x.size());
    row.resize(x.size());
    projector.projectBatch(std::int64_t(x.size()), x.data(), y.data(), z.data(), column.data(),
                           row.data());
  }
};

std::vector<double> moved(std::vector<double> values) {
  for (double& value : values) {
    value += kPointStep;
  }
  return values;
}

/// σ² I + K C Kᵀ, for a point in camera axes and J there: a turn w moves the point by w x p, a
/// shift s by s.
Eigen::Matrix2d pixelCovariance(const Eigen::Matrix<double, 2, 3>& byCameraPoint,
                                const Eigen::Vector3d& pointCamera, double pixelSigma,
                                const PoseCovariance& pose) {
  Eigen::Matrix3d turn;
  turn << 0.0, pointCamera.z(), -pointCamera.y(), -pointCamera.z(), 0.0, pointCamera.x(),
      pointCamera.y(), -pointCamera.x(), 0.0;
  Eigen::Matrix<double, 2, 6> byPose;
  byPose << byCameraPoint * turn, byCameraPoint;
  return pixelSigma * pixelSigma * Eigen::Matrix2d::Identity() + byPose * pose * byPose.transpose();
}

bool isInside(const Intrinsics& in, double column, double row) {
  return column >= -0.5 && row >= -0.5 && column <= in.width - 0.5 && row <= in.height - 0.5;
}

} // namespace

Eigen::Vector3d VolumeGrid::center(int x, int y, int z) const {
  const Eigen::Array3d position(x + 0.5, y + 0.5, z + 0.5);
  const Eigen::Array3d count(cellsPerAxis[0], cellsPerAxis[1], cellsPerAxis[2]);
  return low + ((high - low).array() * position / count).matrix();
}

PoseCovariance poseCovariance(double angle, double distance) {
  PoseCovariance covariance = PoseCovariance::Zero();
  covariance.topLeftCorner<3, 3>().diagonal().setConstant(angle * angle);
  covariance.bottomRightCorner<3, 3>().diagonal().setConstant(distance * distance);
  return covariance;
}

UncertaintyMap::UncertaintyMap(const VolumeGrid& grid, double pixelSigma)
    : grid_(grid), pixelSigma_(pixelSigma) {
  assert(pixelSigma > 0.0);
  const std::size_t count = grid.cellCount();
  x_.reserve(count);
  y_.reserve(count);
  z_.reserve(count);
  for (int z = 0; z < grid.cellsPerAxis[2]; ++z) {
    for (int y = 0; y < grid.cellsPerAxis[1]; ++y) {
      for (int x = 0; x < grid.cellsPerAxis[0]; ++x) {
        const Eigen::Vector3d center = grid.center(x, y, z);
        x_.push_back(center.x());
        y_.push_back(center.y());
        z_.push_back(center.z());
      }
    }
  }
  combine();
}

void UncertaintyMap::setRig(const CameraRig& rig, std::span<const PoseCovariance> covariances) {
  assert(covariances.empty() || covariances.size() == rig.size());
  cameras_.resize(rig.size());
  for (std::size_t k = 0; k < rig.size(); ++k) {
    compute(rig[k], covariances.empty() ? PoseCovariance::Zero() : covariances[k], cameras_[k]);
  }
  combine();
}

void UncertaintyMap::setCamera(std::size_t camera, const Camera& moved,
                               const PoseCovariance& covariance) {
  assert(camera <= cameras_.size());
  if (camera == cameras_.size()) {
    cameras_.emplace_back();
  }
  compute(moved, covariance, cameras_[camera]);
  combine();
}

void UncertaintyMap::compute(const Camera& camera, const PoseCovariance& covariance,
                             Information& information) {
  const Projector projector(camera);
  const Eigen::Matrix3d worldFromCamera = camera.cameraFromWorld.linear().transpose();
  PixelColumns at, alongX, alongY, alongZ;
  at.project(projector, x_, y_, z_);
  alongX.project(projector, moved(x_), y_, z_);
  alongY.project(projector, x_, moved(y_), z_);
  alongZ.project(projector, x_, y_, moved(z_));
  const bool exactPose = covariance.isZero(0.0);
  const double weight = 1.0 / (pixelSigma_ * pixelSigma_);
  information.matrices.assign(x_.size(), {});
  information.isSeen.assign(x_.size(), 0);
  for (std::size_t i = 0; i < x_.size(); ++i) {
    Eigen::Matrix<double, 2, 3> byPoint;
    byPoint << alongX.column[i] - at.column[i], alongY.column[i] - at.column[i],
        alongZ.column[i] - at.column[i], alongX.row[i] - at.row[i], alongY.row[i] - at.row[i],
        alongZ.row[i] - at.row[i];
    byPoint /= kPointStep;
    if (!isInside(camera.intrinsics, at.column[i], at.row[i]) || !byPoint.allFinite()) {
      continue;
    }
    Eigen::Matrix3d given;
    if (exactPose) {
      given = weight * byPoint.transpose() * byPoint;
    } else {
      const Eigen::Vector3d point = camera.cameraFromWorld * Eigen::Vector3d(x_[i], y_[i], z_[i]);
      given = byPoint.transpose() *
              pixelCovariance(byPoint * worldFromCamera, point, pixelSigma_, covariance).inverse() *
              byPoint;
    }
    information.isSeen[i] = 1;
    information.matrices[i] = {float(given(0, 0)), float(given(0, 1)), float(given(0, 2)),
                               float(given(1, 1)), float(given(1, 2)), float(given(2, 2))};
  }
}

void UncertaintyMap::combine() {
  const std::size_t count = x_.size();
  counts_.assign(count, 0);
  largest_.assign(count, kNoValue);
  axes_.assign(count, {kNoValue, kNoValue, kNoValue});
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, 6> sum{};
    for (const Information& camera : cameras_) {
      counts_[i] = std::uint8_t(counts_[i] + camera.isSeen[i]);
      for (std::size_t k = 0; k < 6; ++k) {
        sum[k] += double(camera.matrices[i][k]);
      }
    }
    if (counts_[i] < 2) {
      continue;
    }
    Eigen::Matrix3d information;
    information << sum[0], sum[1], sum[2], sum[1], sum[3], sum[4], sum[2], sum[4], sum[5];
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(information, Eigen::EigenvaluesOnly);
    const Eigen::Vector3d values = solver.eigenvalues();
    if (!(values[0] > kFlattest * values[2])) {
      continue; // the cameras and the point lie on one line
    }
    const Eigen::Matrix3d covariance = information.inverse();
    largest_[i] = float(1.0 / std::sqrt(values[0]));
    for (int axis = 0; axis < 3; ++axis) {
      axes_[i][std::size_t(axis)] = float(std::sqrt(covariance(axis, axis)));
    }
  }
}

std::span<const float> UncertaintyMap::layer(int z) const {
  const std::size_t size = std::size_t(grid_.cellsPerAxis[0]) * std::size_t(grid_.cellsPerAxis[1]);
  return std::span(largest_).subspan(size * std::size_t(z), size);
}

std::optional<int> UncertaintyMap::layerAt(double height) const {
  const double share = (height - grid_.low.z()) / (grid_.high.z() - grid_.low.z());
  if (!(share >= 0.0 && share <= 1.0)) {
    return std::nullopt;
  }
  return std::min(int(share * grid_.cellsPerAxis[2]), grid_.cellsPerAxis[2] - 1);
}

double UncertaintyMap::fractionWithin(double sigma) const {
  const auto good = std::ranges::count_if(largest_, [&](float value) { return value <= sigma; });
  return double(good) / double(std::max<std::size_t>(largest_.size(), 1));
}

} // namespace dewpoint::calibration
