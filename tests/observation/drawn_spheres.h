// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/color/color_range.h"
#include "core/geometry/camera.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace dewpoint::tests::drawn {

/// Of a ball, meters: about 20 pixels of VGA a meter away.
inline constexpr double kRadius = 0.035;

/// A ball of one flat color.
struct Ball {
  Eigen::Vector3d center;
  double radius = kRadius;
  cv::Vec3b color{0, 0, 230}; // blue, green, red
};

/// Takes in the default color of Ball (hue 0, saturation 1) from half of it mixed with the gray of
/// the wall: 230 a / (240 (1 - a) + 230 a) >= 0.5 from a = 0.51.
inline const ColorRange kRed{340.0, 20.0, 0.5, 1.0, 0.1, 0.9};
inline constexpr int kWall = 80; ///< gray level
inline const Eigen::Vector3d kMiddle(0.5, 0.5, 0.2);
inline constexpr int kVga = 2;               ///< the `scale` of rigAround()
inline constexpr double kFrame = 1.0 / 30.0; ///< between two images, seconds

/// `count` cameras one meter around the middle of the desk, none opposite another, all looking at
/// it from above; `scale` 2 is VGA, 1 is QVGA.
inline CameraRig rigAround(int count, int scale = 1) {
  CameraRig rig(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    Camera& camera = rig[static_cast<std::size_t>(k)];
    camera.intrinsics = {320 * scale,   240 * scale,         300.0 * scale,
                         300.0 * scale, 160.0 * scale - 0.5, 120.0 * scale - 0.5};
    const double angle = 80.0 * std::numbers::pi / 180.0 * k - 0.5 * std::numbers::pi;
    const Eigen::Vector3d from =
        kMiddle + Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.4 + 0.05 * k);
    camera.cameraFromWorld = lookAt(from, kMiddle);
  }
  return rig;
}

inline cv::Mat wall(const Camera& camera) {
  return {camera.intrinsics.height, camera.intrinsics.width, CV_8UC3,
          cv::Scalar(kWall, kWall, kWall)};
}

/// Paints a ball over what is there: of each pixel as much as 8 x 8 rays through it hit the sphere.
/// Without lens distortion. Nothing of the product takes part but the camera's numbers.
inline void paint(cv::Mat& image, const Camera& camera, const Ball& ball) {
  const Intrinsics& in = camera.intrinsics;
  const Eigen::Vector3d center = camera.cameraFromWorld * ball.center;
  if (center.z() <= 2.0 * ball.radius) {
    return;
  }
  const double reach = 2.0 * in.focalX * ball.radius / (center.z() - ball.radius) + 3.0;
  const double column = in.focalX * center.x() / center.z() + in.centerX;
  const double row = in.focalY * center.y() / center.z() + in.centerY;
  const auto first = [](double at) { return std::max(0, static_cast<int>(std::floor(at))); };
  const auto last = [](double at, int size) { return std::min(size - 1, static_cast<int>(at)); };
  const double tangent2 = center.squaredNorm() - ball.radius * ball.radius;
  constexpr int kRays = 8;
  for (int y = first(row - reach); y <= last(row + reach, in.height); ++y) {
    for (int x = first(column - reach); x <= last(column + reach, in.width); ++x) {
      int hits = 0;
      for (int ray = 0; ray < kRays * kRays; ++ray) {
        const double u = x - 0.5 + (ray % kRays + 0.5) / kRays;
        const double v = y - 0.5 + (ray / kRays + 0.5) / kRays; // NOLINT(bugprone-integer-division)
        const Eigen::Vector3d way((u - in.centerX) / in.focalX, (v - in.centerY) / in.focalY, 1.0);
        const double along = way.dot(center);
        hits += along > 0.0 && along * along >= way.squaredNorm() * tangent2 ? 1 : 0;
      }
      auto& pixel = image.at<cv::Vec3b>(y, x);
      for (int channel = 0; channel < 3; ++channel) {
        const double share = static_cast<double>(hits) / (kRays * kRays);
        pixel[channel] = cv::saturate_cast<std::uint8_t>(share * ball.color[channel] +
                                                         (1.0 - share) * pixel[channel]);
      }
    }
  }
}

/// Paints the balls from far to near.
inline void paint(cv::Mat& image, const Camera& camera, std::vector<Ball> balls) {
  const auto depth = [&](const Ball& ball) { return (camera.cameraFromWorld * ball.center).z(); };
  std::sort(balls.begin(), balls.end(),
            [&](const Ball& a, const Ball& b) { return depth(a) > depth(b); });
  for (const Ball& ball : balls) {
    paint(image, camera, ball);
  }
}

/// The balls before the wall.
inline cv::Mat draw(const Camera& camera, const std::vector<Ball>& balls) {
  cv::Mat image = wall(camera);
  paint(image, camera, balls);
  return image;
}

/// Normal noise of `sigma` gray levels, a function of seed and frame: one table of random numbers,
/// read from another place every time.
inline void addNoise(cv::Mat& image, double sigma, std::uint32_t frame, std::uint64_t seed = 99) {
  static const std::vector<float> table = [] {
    constexpr std::uint32_t kBlocks = 65521; // a prime, so that rows do not repeat
    const RandomStream stream(1, 0, 0, RandomPurpose::Noise);
    std::vector<float> normals;
    for (std::uint32_t block = 0; block < kBlocks; ++block) {
      for (const double normal : stream.normal4(block)) {
        normals.push_back(static_cast<float>(normal));
      }
    }
    return normals;
  }();
  std::size_t at = static_cast<std::size_t>(
      RandomStream(seed, frame, 0, RandomPurpose::Noise).uniform(0) * double(table.size()));
  const auto strength = static_cast<float>(sigma);
  for (int row = 0; row < image.rows; ++row) {
    auto* bytes = image.ptr<std::uint8_t>(row);
    for (int k = 0; k < 3 * image.cols; ++k) {
      bytes[k] = cv::saturate_cast<std::uint8_t>(float(bytes[k]) + strength * table[at]);
      at = at + 1 < table.size() ? at + 1 : 0;
    }
  }
}

/// A place within `reach` meters of the middle of the desk along each axis.
inline Eigen::Vector3d placeNear(std::uint32_t index, double reach, std::uint64_t seed = 5) {
  const auto unit = RandomStream(seed, 0, 0, RandomPurpose::Simulation).uniform3(index);
  return kMiddle +
         reach * Eigen::Vector3d(2.0 * unit[0] - 1.0, 2.0 * unit[1] - 1.0, 2.0 * unit[2] - 1.0);
}

/// A direction in space, evenly distributed.
inline Eigen::Vector3d directionOf(std::uint32_t index, std::uint64_t seed = 6) {
  const auto normal = RandomStream(seed, 0, 0, RandomPurpose::Simulation).normal4(index);
  return Eigen::Vector3d(normal[0], normal[1], normal[2]).normalized();
}

} // namespace dewpoint::tests::drawn
