// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/clicks/clicked_position.h"

#include "core/geometry/projector.h"
#include "core/geometry/ray.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace dewpoint::setup {
namespace {

/// Pixels, standard deviation of a click along each axis: a judgment, for a hand that aims at the
/// middle of something blurred.
constexpr double kClickSigmaPx = 2.0;
// Depths along a ray at which the other cameras are asked whether they see it, meters: 0.05 to
// 1000, each 2 % more than the one before.
constexpr double kNearestDepth = 0.05;
constexpr double kDepthStep = 1.02;
constexpr int kDepthCount = 500;

/// The ray of a click.
struct ClickRay {
  Ray ray;
  double spread = 0.0; ///< standard deviation across the ray per meter of depth
};

Result<ClickRay> rayOf(const CameraRig& rig, const PointClick& click) {
  const auto index = static_cast<std::size_t>(click.camera);
  if (click.camera < 0 || index >= rig.size()) {
    return failure(ErrorCode::BadValue, "", "camera",
                   fmt::format("there is no camera {}", click.camera + 1));
  }
  const Camera& camera = rig[index];
  const auto ray = Unprojector(camera).ray(click.pixel);
  if (!ray) {
    return failure(ErrorCode::Undetermined, "", camera.name,
                   "the lens model gives no ray at this pixel");
  }
  const double focal = std::min(camera.intrinsics.focalX, camera.intrinsics.focalY);
  return ClickRay{*ray, kClickSigmaPx / focal};
}

Eigen::Matrix3d alongOf(const Ray& ray) {
  return ray.direction * ray.direction.transpose();
}

Result<Gaussian3> rayIntersection(const std::vector<ClickRay>& clicks) {
  std::vector<Ray> rays;
  std::ranges::transform(clicks, std::back_inserter(rays), &ClickRay::ray);
  const auto point = nearestPoint(rays);
  if (!point) {
    return failure(ErrorCode::Undetermined, "", "clicks",
                   "their rays do not meet in front of the cameras");
  }
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  double misfit = 0.0; // squared standard deviations
  for (const ClickRay& click : clicks) {
    const double sigma = click.spread * (*point - click.ray.origin).norm();
    information += (Eigen::Matrix3d::Identity() - alongOf(click.ray)) / (sigma * sigma);
    misfit += std::pow(distanceToRay(click.ray, *point) / sigma, 2);
  }
  const double degreesOfFreedom = 2.0 * static_cast<double>(clicks.size()) - 3.0;
  const Eigen::Matrix3d covariance =
      std::max(1.0, misfit / degreesOfFreedom) * information.inverse();
  return Gaussian3{*point, 0.5 * (covariance + covariance.transpose())};
}

/// The point of a ray at a depth that is off by `depthVariance` (m²).
Gaussian3 pointAt(const ClickRay& click, double depth, double depthVariance) {
  const double across = click.spread * depth;
  return {click.ray.origin + depth * click.ray.direction,
          across * across * Eigen::Matrix3d::Identity() + depthVariance * alongOf(click.ray)};
}

bool sees(const Projector& camera, const Eigen::Vector3d& point) {
  const auto pixel = camera.project(point);
  const Intrinsics& image = camera.intrinsics();
  return pixel && pixel->x() >= -0.5 && pixel->x() < image.width - 0.5 && pixel->y() >= -0.5 &&
         pixel->y() < image.height - 0.5;
}

/// Inverse depths, 1/m, between which the most other cameras see the ray.
struct SeenPart {
  double nearest = 0.0;
  double farthest = 0.0; ///< 0: endless
};

std::optional<SeenPart> partSeenByOthers(const CameraRig& rig, const PointClick& click,
                                         const Ray& ray) {
  std::vector<Projector> others;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    if (k != static_cast<std::size_t>(click.camera)) {
      others.emplace_back(rig[k]);
    }
  }
  std::optional<SeenPart> part;
  std::ptrdiff_t most = 1;
  double depth = kNearestDepth;
  for (int k = 0; k < kDepthCount; ++k, depth *= kDepthStep) {
    const Eigen::Vector3d point = ray.origin + depth * ray.direction;
    const auto count =
        std::ranges::count_if(others, [&](const Projector& other) { return sees(other, point); });
    if (count < most) {
      continue;
    }
    if (!part || count > most) {
      part = SeenPart{1.0 / depth, 1.0 / depth};
    }
    most = count;
    part->farthest = k + 1 < kDepthCount ? 1.0 / depth : 0.0;
  }
  return part;
}

Result<Gaussian3> pointOnRay(const CameraRig& rig, const PointClick& click, const ClickRay& ray,
                             const std::optional<Gaussian3>& estimate) {
  const Eigen::Vector3d& along = ray.ray.direction;
  const double depth = estimate ? (estimate->mean - ray.ray.origin).dot(along) : 0.0;
  if (depth > 0.0) {
    const double across = distanceToRay(ray.ray, estimate->mean);
    return pointAt(ray, depth, across * across + along.dot(estimate->covariance * along));
  }
  const auto part = partSeenByOthers(rig, click, ray.ray);
  if (!part) {
    return failure(ErrorCode::Undetermined, "", rig[static_cast<std::size_t>(click.camera)].name,
                   "no other camera sees the object at this pixel, so its depth is unknown");
  }
  const double middle = 2.0 / (part->nearest + part->farthest);
  const double sigma = middle * middle * (part->nearest - part->farthest) / std::sqrt(12.0);
  return pointAt(ray, middle, sigma * sigma);
}

} // namespace

Result<Gaussian3> positionFromClicks(const CameraRig& rig, const std::vector<PointClick>& clicks,
                                     const std::optional<Gaussian3>& estimate) {
  std::vector<ClickRay> rays;
  for (const PointClick& click : clicks) {
    const auto ray = rayOf(rig, click);
    if (!ray) {
      return tl::make_unexpected(ray.error());
    }
    rays.push_back(*ray);
  }
  if (rays.empty()) {
    return failure(ErrorCode::BadValue, "", "clicks", "there is none");
  }
  return rays.size() > 1 ? rayIntersection(rays)
                         : pointOnRay(rig, clicks.front(), rays.front(), estimate);
}

} // namespace dewpoint::setup
