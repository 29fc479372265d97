// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/room/room_view.h"

#include "core/geometry/projector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace dewpoint::simulation {
namespace {

/// The direction (z = 1, camera frame) whose image is `pixel`: a fixed point of the projection.
/// Nothing where the lens model has no such direction.
std::optional<Eigen::Vector3d> unproject(const Projector& lens, const Eigen::Vector2d& pixel) {
  /// Iterations of undistorting a pixel, at most; chosen: it ends when it moves no more.
  constexpr int kIterations = 30;
  constexpr double kEnough = 1e-4; // pixels; far below what a sample can show
  const Intrinsics& k = lens.intrinsics();
  Eigen::Vector3d ray{(pixel.x() - k.centerX) / k.focalX, (pixel.y() - k.centerY) / k.focalY, 1.0};
  for (int i = 0; i < kIterations; ++i) {
    const auto image = lens.project(ray);
    if (!image) {
      // Beyond the lens: come back towards the axis.
      ray.head<2>() *= 0.7;
      continue;
    }
    const Eigen::Vector2d miss = pixel - *image;
    if (miss.squaredNorm() < kEnough * kEnough) {
      return ray;
    }
    ray.x() += miss.x() / k.focalX;
    ray.y() += miss.y() / k.focalY;
  }
  return std::nullopt;
}

} // namespace

std::array<float, 2> subpixelOffset(int sample, int side) {
  const int row = sample / side;
  const int column = sample % side;
  const auto offset = [side](int index) {
    return (static_cast<float>(index) + 0.5F) / static_cast<float>(side) - 0.5F;
  };
  return {offset(column), offset(row)};
}

RoomView::RoomView(const Camera& camera, const Room& room)
    : projector(camera), width(camera.intrinsics.width), height(camera.intrinsics.height),
      center(camera.center().cast<float>()) {
  castRays(camera);
  renderRoom(room);
}

void RoomView::castRays(const Camera& camera) {
  Camera atOrigin = camera;
  atOrigin.cameraFromWorld.setIdentity();
  const Projector lens(atOrigin);
  const Eigen::Matrix3d worldFromCamera = camera.cameraFromWorld.linear().transpose();
  directions.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                    Vector3f::Zero());
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      if (const auto ray = unproject(lens, {column, row})) {
        directions[pixelIndex(column, row)] = (worldFromCamera * ray->normalized()).cast<float>();
      }
    }
  }
}

Vector3f RoomView::rayDirection(int column, int row, float right, float down) const {
  const Vector3f& here = directions[pixelIndex(column, row)];
  const int nextColumn = column + 1 < width ? column + 1 : std::max(0, column - 1);
  const int nextRow = row + 1 < height ? row + 1 : std::max(0, row - 1);
  const auto step = [&](const Vector3f& next, int sign) -> Vector3f {
    return next.isZero(0.0F) ? Vector3f::Zero()
                             : Vector3f(static_cast<float>(sign) * (next - here));
  };
  const Vector3f there =
      here + right * step(directions[pixelIndex(nextColumn, row)], nextColumn - column) +
      down * step(directions[pixelIndex(column, nextRow)], nextRow - row);
  return there.normalized();
}

void RoomView::renderRoom(const Room& room) {
  constexpr int kSide = 2; // 2x2 samples per pixel; chosen: what is at rest is rendered once
  distances.assign(directions.size(), std::numeric_limits<float>::infinity());
  lampFractions.assign(directions.size(), 0.0F);
  background = cv::Mat::zeros(height, width, CV_32FC3);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const std::size_t pixel = pixelIndex(column, row);
      if (directions[pixel].isZero(0.0F)) {
        continue;
      }
      distances[pixel] = room.castRay(center, directions[pixel]).distance;
      Vector3f color = Vector3f::Zero();
      for (int sample = 0; sample < kSide * kSide; ++sample) {
        const auto [right, down] = subpixelOffset(sample, kSide);
        const Vector3f ray = rayDirection(column, row, right, down);
        const auto jitter =
            static_cast<std::uint32_t>(pixel) * 4U + static_cast<std::uint32_t>(sample);
        const ShadedColor sight =
            room.shadedColorOf(center, ray, room.castRay(center, ray), jitter);
        color += sight.color / (kSide * kSide);
        lampFractions[pixel] += sight.lampFraction / (kSide * kSide);
      }
      background.at<cv::Vec3f>(row, column) = {color.x(), color.y(), color.z()};
    }
  }
}

cv::Rect RoomView::boundsOfSphere(const Eigen::Vector3d& sphere, double radius) const {
  constexpr int kPoints = 32;     // of the silhouette; between two it bulges by 0.5 % of the radius
  constexpr double kMargin = 2.0; // pixels; more than the silhouette bulges between the points
  const Eigen::Vector3d eye = center.cast<double>();
  const Eigen::Vector3d way = sphere - eye;
  const double distance = way.norm();
  if (distance <= radius) {
    return {};
  }
  // The tangent cone touches the sphere in a circle around `middle`.
  const double cut = radius * radius / distance;
  const Eigen::Vector3d axis = way / distance;
  const Eigen::Vector3d middle = sphere - cut * axis;
  const double rim = std::sqrt(radius * radius - cut * radius * radius / distance);
  const Eigen::Vector3d u = axis.unitOrthogonal() * rim;
  const Eigen::Vector3d v = axis.cross(u);
  Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array2d high = -low;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kPoints;
    const auto pixel = projector.project(middle + std::cos(angle) * u + std::sin(angle) * v);
    if (!pixel) {
      // Partly behind the camera or beyond the lens: search everywhere, if it is seen at all.
      const bool visible = i > 0 || projector.project(sphere).has_value();
      return visible ? cv::Rect{0, 0, width, height} : cv::Rect{};
    }
    low = low.min(pixel->array());
    high = high.max(pixel->array());
  }
  const Eigen::Array2d size{static_cast<double>(width), static_cast<double>(height)};
  const Eigen::Array2i first = (low - kMargin).max(0.0).min(size).cast<int>();
  const Eigen::Array2i last = (high + kMargin + 1.0).max(0.0).min(size).cast<int>();
  return {first.x(), first.y(), last.x() - first.x(), last.y() - first.y()};
}

} // namespace dewpoint::simulation
