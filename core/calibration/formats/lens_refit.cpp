// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/lens_refit.h"

#include "core/geometry/projector.h"
#include "core/geometry/ray.h"

#include <algorithm>
#include <ceres/ceres.h>
#include <cmath>
#include <limits>
#include <memory>

namespace dewpoint::calibration {
namespace {

constexpr int kSamples = 33;          // along each side of the image
constexpr double kSteepest = 0.08716; // cosine of 85 degrees
constexpr int kFocalX = 0, kFocalY = 1, kCenterX = 2, kCenterY = 3, kFirstCoefficient = 4;
constexpr int kParameters = kFirstCoefficient + 8;

/// One pixel, and the direction (camera axes, at depth 1) that is seen there.
struct Sample {
  Eigen::Vector2d direction;
  Eigen::Vector2d pixel;
};

std::vector<Sample> samples(Camera camera) {
  camera.cameraFromWorld.setIdentity();
  const Unprojector unprojector(camera);
  std::vector<Sample> result;
  for (int row = 0; row < kSamples; ++row) {
    for (int column = 0; column < kSamples; ++column) {
      const Eigen::Vector2d pixel(column * (camera.intrinsics.width - 1.0) / (kSamples - 1),
                                  row * (camera.intrinsics.height - 1.0) / (kSamples - 1));
      const auto ray = unprojector.worldDirection(pixel);
      if (ray && ray->z() > kSteepest) {
        result.push_back({ray->hnormalized(), pixel});
      }
    }
  }
  return result;
}

/// OpenCV's pinhole (see Projection::pixel), for Ceres.
struct PinholeCost {
  Sample sample;

  template <typename T> bool operator()(const T* const p, T* residual) const {
    const T u(sample.direction.x());
    const T v(sample.direction.y());
    const T s = u * u + v * v;
    const T* k = p + kFirstCoefficient;
    const T factor =
        (1.0 + s * (k[0] + s * (k[1] + s * k[4]))) / (1.0 + s * (k[5] + s * (k[6] + s * k[7])));
    const T x = u * factor + 2.0 * k[2] * u * v + k[3] * (s + 2.0 * u * u);
    const T y = v * factor + k[2] * (s + 2.0 * v * v) + 2.0 * k[3] * u * v;
    residual[0] = p[kFocalX] * x + p[kCenterX] - sample.pixel.x();
    residual[1] = p[kFocalY] * y + p[kCenterY] - sample.pixel.y();
    return true;
  }
};

std::array<double, kParameters> startOf(const Camera& camera, int coefficients) {
  const auto& in = camera.intrinsics;
  std::array<double, kParameters> start{in.focalX, in.focalY, in.centerX, in.centerY};
  if (camera.lens == LensModel::Pinhole) {
    std::copy_n(camera.distortion.begin(), coefficients, start.begin() + kFirstCoefficient);
  }
  return start;
}

void solve(const std::vector<Sample>& seen, int coefficients,
           std::array<double, kParameters>& parameters) {
  ceres::Problem problem;
  for (const Sample& sample : seen) {
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<PinholeCost, 2, kParameters>(new PinholeCost{sample}),
        nullptr, parameters.data());
  }
  std::vector<int> fixed;
  for (int k = coefficients; k < 8; ++k) {
    fixed.push_back(kFirstCoefficient + k);
  }
  if (!fixed.empty()) {
    problem.SetManifold(parameters.data(), new ceres::SubsetManifold(kParameters, fixed));
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-14;
  options.parameter_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
}

void measure(const std::vector<Sample>& seen, LensRefit& refit) {
  Camera camera = refit.camera;
  camera.cameraFromWorld.setIdentity();
  const Projector projector(camera);
  double sum = 0.0;
  for (const Sample& sample : seen) {
    const auto pixel = projector.project(sample.direction.homogeneous());
    const double distance =
        pixel ? (*pixel - sample.pixel).norm() : std::numeric_limits<double>::infinity();
    refit.maxDifferencePx = std::max(refit.maxDifferencePx, distance);
    sum += distance * distance;
  }
  refit.rmsDifferencePx = std::sqrt(sum / double(std::max<std::size_t>(seen.size(), 1)));
}

} // namespace

bool isLensSupported(const Camera& camera, const LensSupport& range) {
  if (camera.lens == LensModel::Fisheye) {
    return range.supportsFisheye;
  }
  return std::all_of(camera.distortion.begin() + range.pinholeCoefficientCount,
                     camera.distortion.end(), [](double value) { return value == 0.0; });
}

LensRefit refitLens(const Camera& camera, const LensSupport& range) {
  LensRefit refit;
  refit.camera = camera;
  if (isLensSupported(camera, range)) {
    return refit;
  }
  const auto seen = samples(camera);
  auto parameters = startOf(camera, range.pinholeCoefficientCount);
  solve(seen, range.pinholeCoefficientCount, parameters);
  refit.isRefitted = true;
  refit.camera.lens = LensModel::Pinhole;
  auto& in = refit.camera.intrinsics;
  in.focalX = parameters[kFocalX];
  in.focalY = parameters[kFocalY];
  in.centerX = parameters[kCenterX];
  in.centerY = parameters[kCenterY];
  std::copy_n(parameters.begin() + kFirstCoefficient, 8, refit.camera.distortion.begin());
  measure(seen, refit);
  return refit;
}

} // namespace dewpoint::calibration
