// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/manual/point_bundle.h"

#include "core/calibration/manual/camera_variation.h"

#include <array>
#include <ceres/ceres.h>

namespace dewpoint::calibration {
namespace {

/// A click against the projection of its point: camera changed by six numbers (see
/// CameraVariation), the point moved by three, meters. In standard deviations of a click.
class ClickCost {
public:
  ClickCost(const Camera& camera, double depth, Eigen::Vector3d world, Eigen::Vector2d pixel,
            double sigma)
      : change_(camera, depth), world_(std::move(world)), pixel_(std::move(pixel)), sigma_(sigma) {}

  bool operator()(const double* pose, const double* offset, double* residual) const {
    ChangeVector change = ChangeVector::Zero();
    change.head<6>() = Eigen::Map<const Eigen::Matrix<double, 6, 1>>(pose);
    const auto seen =
        change_.projectedPixel(change, world_ + Eigen::Map<const Eigen::Vector3d>(offset));
    if (!seen) {
      return false;
    }
    Eigen::Map<Eigen::Vector2d>{residual} = (*seen - pixel_) / sigma_;
    return true;
  }

private:
  CameraVariation change_;
  Eigen::Vector3d world_;
  Eigen::Vector2d pixel_;
  double sigma_;
};

/// What the tape said, in its standard deviations.
struct TapeCost {
  double sigma;
  template <class T> bool operator()(const T* offset, T* residual) const {
    for (int axis = 0; axis < 3; ++axis) {
      residual[axis] = offset[axis] / sigma;
    }
    return true;
  }
};

} // namespace

void refineCamerasAndPoints(CameraRig& rig, const std::vector<bool>& solved,
                            const std::vector<MeasuredPoint>& points,
                            const PointSettings& settings) {
  std::vector<std::array<double, 6>> poses(rig.size(), std::array<double, 6>{});
  std::vector<std::array<double, 3>> offsets(points.size(), std::array<double, 3>{});
  std::vector<double> depths(rig.size(), 1.0);
  ceres::Problem problem;
  std::vector<bool> used(points.size(), false);
  for (std::size_t c = 0; c < rig.size(); ++c) {
    std::vector<ImageAnchor> anchors;
    for (const MeasuredPoint& point : points) {
      if (const PointClick* click = findClick(point, static_cast<int>(c))) {
        anchors.push_back({point.world, click->pixel});
      }
    }
    depths[c] = meanDistance(rig[c], anchors);
    for (std::size_t k = 0; solved[c] && k < points.size(); ++k) {
      if (const PointClick* click = findClick(points[k], static_cast<int>(c))) {
        using Cost = ceres::NumericDiffCostFunction<ClickCost, ceres::CENTRAL, 2, 6, 3>;
        auto* cost =
            new ClickCost(rig[c], depths[c], points[k].world, click->pixel, settings.clickSigma);
        problem.AddResidualBlock(new Cost(cost), nullptr, poses[c].data(), offsets[k].data());
        used[k] = true;
      }
    }
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (used[k]) {
      using Cost = ceres::AutoDiffCostFunction<TapeCost, 3, 3>;
      problem.AddResidualBlock(new Cost(new TapeCost{settings.tapeSigma}), nullptr,
                               offsets[k].data());
    }
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_SCHUR;
  options.max_num_iterations = 50;
  options.function_tolerance = 1e-14;
  options.parameter_tolerance = 1e-12;
  options.gradient_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (!summary.IsSolutionUsable()) {
    return; // what each camera found alone stays
  }
  for (std::size_t c = 0; c < rig.size(); ++c) {
    if (solved[c]) {
      ChangeVector change = ChangeVector::Zero();
      change.head<6>() = Eigen::Map<const Eigen::Matrix<double, 6, 1>>(poses[c].data());
      rig[c] = CameraVariation(rig[c], depths[c]).changedCamera(change);
    }
  }
}

} // namespace dewpoint::calibration
