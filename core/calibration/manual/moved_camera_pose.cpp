// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/manual/moved_camera_pose.h"

#include "core/base/statistics.h"
#include "core/calibration/bundle/bundle_cost.h"
#include "core/geometry/projector.h"
#include "core/geometry/rotation_vector.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/sized_cost_function.h>
#include <ceres/solver.h>
#include <cmath>
#include <deque>
#include <optional>
#include <vector>

namespace dewpoint::calibration {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kHuber = 2.0;          // sigmas
constexpr double kAgrees = 3.0;         // sigmas
constexpr double kBackgroundAt = 3.0;   // meters
constexpr double kMovedPoseStep = 1e-6; // radians and meters, of the differences
constexpr double kUnseenSightingPx =
    50.0; // pixels a sighting counts as off that the camera cannot see

/// The camera after a turn (rad) about its center and a shift (m) of it, both in camera axes.
Camera movedCamera(const Camera& camera, const Vector6& change) {
  Camera moved = rotatedCamera(camera, change.head<3>());
  moved.cameraFromWorld.translation() -= change.tail<3>();
  return moved;
}

/// A change of the pose, as what it does to points in camera axes.
struct PointMotion {
  Eigen::Matrix3d turn;
  Eigen::Vector3d shift;

  explicit PointMotion(const Vector6& change)
      : turn(rotationFromVector(change.head<3>())), shift(change.tail<3>()) {}
  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return turn * point - shift; }
};

/// Off by so many sigma, for a point in the axes that the projector starts from.
std::optional<Eigen::Vector2d> residual(const Projector& lens, const Eigen::Vector3d& point,
                                        const PointSighting& sighting) {
  const auto pixel = lens.project(point);
  if (!pixel) {
    return std::nullopt;
  }
  return Eigen::Vector2d((*pixel - sighting.pixel) / sighting.sigmaPixels);
}

/// What a sighting has against a change of the pose, in sigmas.
class SightingCost final : public ceres::SizedCostFunction<2, 6> {
public:
  SightingCost(const Camera& camera, const Projector& lens, const PointSighting& sighting)
      : lens_(lens), sighting_(sighting), point_(camera.cameraFromWorld * sighting.world) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Vector6 change = Eigen::Map<const Vector6>(parameters[0]);
    Eigen::Map<Eigen::Vector2d> out(residuals);
    const auto off = at(change);
    // What the camera cannot see costs as much as kUnseenSightingPx, whichever way it goes.
    out = off.value_or(
        Eigen::Vector2d(0.5 * kHuber + kUnseenSightingPx / sighting_.sigmaPixels, 0.0));
    if (jacobians == nullptr || jacobians[0] == nullptr) {
      return true;
    }
    Eigen::Map<Eigen::Matrix<double, 2, 6, Eigen::RowMajor>> byChange(jacobians[0]);
    byChange.setZero();
    for (int k = 0; off && k < 6; ++k) {
      if (const auto there = at(change + kMovedPoseStep * Vector6::Unit(k))) {
        byChange.col(k) = (*there - *off) / kMovedPoseStep;
      }
    }
    return true;
  }

private:
  std::optional<Eigen::Vector2d> at(const Vector6& change) const {
    return residual(lens_, PointMotion(change) * point_, sighting_);
  }

  const Projector& lens_; ///< the camera at the world's origin
  const PointSighting& sighting_;
  Eigen::Vector3d point_;
};

class Solver {
public:
  Solver(const Camera& camera, const CameraMotionPrior& prior,
         std::span<const PointSighting> sightings)
      : lens_(withoutPose(camera)) {
    mean_ << prior.turn, Eigen::Vector3d::Zero();
    const double turn = std::hypot(prior.rotationSigma, prior.shiftSigma / kBackgroundAt);
    sigmas_ << Eigen::Vector3d::Constant(turn), Eigen::Vector3d::Constant(prior.shiftSigma);
    for (const PointSighting& sighting : sightings) {
      costs_.emplace_back(camera, lens_, sighting);
    }
  }
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  /// The change of least cost, from the prior's.
  Vector6 solve() {
    Vector6 change = mean_;
    ceres::Problem::Options ownership;
    ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    PriorCost prior({mean_.begin(), mean_.end()}, {sigmas_.begin(), sigmas_.end()});
    ceres::HuberLoss loss(kHuber);
    ceres::Problem problem(ownership);
    problem.AddResidualBlock(&prior, nullptr, change.data());
    for (SightingCost& cost : costs_) {
      problem.AddResidualBlock(&cost, &loss, change.data());
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = 50;
    options.function_tolerance = 1e-12;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    return change;
  }

  /// The inverse of the information that prior and sightings, each by its weight, have there.
  Matrix6 covarianceAt(const Vector6& change) const {
    Matrix6 information = sigmas_.array().square().inverse().matrix().asDiagonal();
    for (const SightingCost& cost : costs_) {
      Eigen::Vector2d off;
      Eigen::Matrix<double, 2, 6, Eigen::RowMajor> byChange;
      const double* parameters[] = {change.data()};
      double* jacobians[] = {byChange.data()};
      cost.Evaluate(parameters, off.data(), jacobians);
      const double distance = off.norm();
      const double weight = distance > kHuber ? kHuber / distance : 1.0;
      information += weight * byChange.transpose() * byChange;
    }
    return information.inverse();
  }

private:
  Projector lens_; ///< the camera at the world's origin
  std::deque<SightingCost> costs_;
  Vector6 mean_, sigmas_;
};

double medianPixels(const Camera& camera, std::span<const PointSighting> sightings) {
  const Projector projector(camera);
  std::vector<double> distances;
  for (const PointSighting& sighting : sightings) {
    const auto off = residual(projector, sighting.world, sighting);
    distances.push_back(off ? off->norm() * sighting.sigmaPixels : kUnseenSightingPx);
  }
  return upperMedian(std::move(distances));
}

} // namespace

Camera rotatedCamera(const Camera& camera, const Eigen::Vector3d& turn) {
  Camera rotated = camera;
  Eigen::Isometry3d rotation = Eigen::Isometry3d::Identity();
  rotation.linear() = rotationFromVector(turn);
  rotated.cameraFromWorld = rotation * camera.cameraFromWorld;
  return rotated;
}

Result<MovedCameraPose> estimateMovedPose(const Camera& camera, const CameraMotionPrior& prior,
                                          std::span<const PointSighting> sightings) {
  Solver solver(camera, prior, sightings);
  const Vector6 change = solver.solve();
  MovedCameraPose moved;
  moved.camera = movedCamera(camera, change);
  moved.medianResidualPxBefore = medianPixels(camera, sightings);
  moved.medianResidualPxAfter = medianPixels(moved.camera, sightings);
  const Matrix6 covariance = solver.covarianceAt(change);
  moved.angleSigma = covariance.diagonal().head<3>().cwiseSqrt();
  moved.shiftSigma = covariance.diagonal().tail<3>().cwiseSqrt();
  const Projector projector(moved.camera);
  for (const PointSighting& sighting : sightings) {
    const auto off = residual(projector, sighting.world, sighting);
    moved.usedSightingCount += off && off->norm() < kAgrees ? 1 : 0;
  }
  if (2 * std::size_t(moved.usedSightingCount) < sightings.size()) {
    return failure(ErrorCode::Mismatch, "", camera.name,
                   fmt::format("only {} of {} detections agree with any pose near the previous "
                               "one; calibrate this camera again",
                               moved.usedSightingCount, sightings.size()));
  }
  return moved;
}

} // namespace dewpoint::calibration
