// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/manual/camera_variation.h"

#include "core/geometry/rotation_vector.h"

#include <algorithm>
#include <ceres/cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <cmath>

namespace dewpoint::calibration {
namespace {

/// The residuals of a change, as Ceres asks for them: of its first six numbers, or all seven.
class PoseCost final : public ceres::CostFunction {
public:
  PoseCost(const CameraVariation& around, const std::vector<ImageAnchor>& anchors, int size)
      : around_(around), anchors_(anchors), size_(size) {
    set_num_residuals(2 * static_cast<int>(anchors.size()));
    mutable_parameter_block_sizes()->push_back(size);
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    ChangeVector change = ChangeVector::Zero();
    change.head(size_) = Eigen::Map<const Eigen::VectorXd>(parameters[0], size_);
    const auto off = around_.residuals(change, anchors_);
    if (!off) {
      return false; // not seen from there: no step goes so far
    }
    Eigen::Map<Eigen::VectorXd>(residuals, off->size()) = *off;
    if (jacobians == nullptr || jacobians[0] == nullptr) {
      return true;
    }
    const auto byChange = around_.jacobian(change, anchors_);
    if (!byChange) {
      return false;
    }
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<Rows>(jacobians[0], off->size(), size_) = byChange->leftCols(size_);
    return true;
  }

private:
  const CameraVariation& around_;
  const std::vector<ImageAnchor>& anchors_;
  int size_;
};

} // namespace

CameraVariation::CameraVariation(const Camera& camera, double depth)
    : camera_(camera), lens_(withoutPose(camera)), depth_(depth) {}

Eigen::Isometry3d CameraVariation::step(const ChangeVector& change) const {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = rotationFromVector(change.head<3>());
  result.translation() = depth_ * change.segment<3>(3);
  return result;
}

Camera CameraVariation::changedCamera(const ChangeVector& change) const {
  Camera result = camera_;
  result.cameraFromWorld = step(change) * camera_.cameraFromWorld;
  result.intrinsics.focalX *= std::exp(change[6]);
  result.intrinsics.focalY *= std::exp(change[6]);
  return result;
}

std::optional<Eigen::Vector2d> CameraVariation::projectedPixel(const ChangeVector& change,
                                                               const Eigen::Vector3d& world) const {
  const auto seen = lens_.project(step(change) * (camera_.cameraFromWorld * world));
  if (!seen) {
    return std::nullopt;
  }
  const Eigen::Vector2d center(camera_.intrinsics.centerX, camera_.intrinsics.centerY);
  return center + std::exp(change[6]) * (*seen - center);
}

std::optional<Eigen::VectorXd>
CameraVariation::residuals(const ChangeVector& change,
                           const std::vector<ImageAnchor>& anchors) const {
  Eigen::VectorXd result(2 * static_cast<Eigen::Index>(anchors.size()));
  for (std::size_t k = 0; k < anchors.size(); ++k) {
    const auto seen = projectedPixel(change, anchors[k].world);
    if (!seen) {
      return std::nullopt;
    }
    result.segment<2>(2 * static_cast<Eigen::Index>(k)) = *seen - anchors[k].pixel;
  }
  return result;
}

std::optional<Eigen::MatrixXd>
CameraVariation::jacobian(const ChangeVector& change,
                          const std::vector<ImageAnchor>& anchors) const {
  /// Radians and shares of the depth, of the differences.
  constexpr double kDifference = 1e-6;
  Eigen::MatrixXd result(2 * static_cast<Eigen::Index>(anchors.size()), 7);
  for (int column = 0; column < 7; ++column) {
    ChangeVector step = ChangeVector::Zero();
    step[column] = kDifference;
    const auto after = residuals(change + step, anchors);
    const auto before = residuals(change - step, anchors);
    if (!after || !before) {
      return std::nullopt;
    }
    result.col(column) = (*after - *before) / (2.0 * kDifference);
  }
  return result;
}

double meanDistance(const Camera& camera, const std::vector<ImageAnchor>& anchors) {
  double sum = 0.0;
  for (const ImageAnchor& anchor : anchors) {
    sum += (camera.cameraFromWorld * anchor.world).norm();
  }
  return std::max(0.01, sum / static_cast<double>(std::max<std::size_t>(1, anchors.size())));
}

double rmsOfPoints(const Eigen::VectorXd& residuals) {
  return std::sqrt(residuals.squaredNorm() /
                   static_cast<double>(std::max<Eigen::Index>(1, residuals.size() / 2)));
}

std::optional<double> refinePose(Camera& camera, const std::vector<ImageAnchor>& anchors,
                                 bool estimatesFocal) {
  // A change is a small rotation; from where it led, the next one is small again.
  /// Steps of the solver.
  constexpr int kMostRounds = 10;
  constexpr double kGain = 1e-9; // of the sum of squares: more rounds win nothing
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 60;
  options.max_num_consecutive_invalid_steps = 20; // past where points are seen: come back
  options.function_tolerance = 1e-16;
  options.gradient_tolerance = 1e-14;
  options.parameter_tolerance = 1e-13;
  options.logging_type = ceres::SILENT;
  std::optional<double> rms;
  for (int round = 0; round < kMostRounds; ++round) {
    const CameraVariation around(camera, meanDistance(camera, anchors));
    ChangeVector change = ChangeVector::Zero();
    ceres::Problem problem;
    problem.AddResidualBlock(new PoseCost(around, anchors, estimatesFocal ? 7 : 6), nullptr,
                             change.data());
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    const auto residuals =
        summary.IsSolutionUsable() ? around.residuals(change, anchors) : std::nullopt;
    if (!residuals) {
      return rms;
    }
    camera = around.changedCamera(change);
    rms = rmsOfPoints(*residuals);
    if (summary.final_cost >= (1.0 - kGain) * summary.initial_cost) {
      break;
    }
  }
  return rms;
}

PoseShift poseShift(const Camera& before, const Camera& after) {
  return {(after.center() - before.center()).norm(),
          angleBetween(after.cameraFromWorld.linear(), before.cameraFromWorld.linear())};
}

} // namespace dewpoint::calibration
