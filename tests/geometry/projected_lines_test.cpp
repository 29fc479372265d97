// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/projected_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::tests {
namespace {

/// At the world's origin, looking along +z (x right, y down): the pixel of (x, y, z) is
/// 320 + 500 x / z, 240 + 500 y / z.
Camera plainCamera() {
  Camera camera;
  camera.intrinsics = {640, 480, 500.0, 500.0, 320.0, 240.0};
  return camera;
}

Eigen::Vector2d plainPixel(const Eigen::Vector3d& point) {
  return {320.0 + 500.0 * point.x() / point.z(), 240.0 + 500.0 * point.y() / point.z()};
}

TEST(ProjectedLines, ABoxHasTwelveEdgesThatMeetInItsCorners) {
  const auto edges = edgesOf({{-1, -2, -3}, {1, 2, 3}});
  double length = 0.0;
  for (const auto& [from, to] : edges) {
    EXPECT_EQ((to - from).cwiseAbs().maxCoeff(), (to - from).norm()); // along one axis
    EXPECT_EQ(from.cwiseAbs(), Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(to.cwiseAbs(), Eigen::Vector3d(1, 2, 3));
    length += (to - from).norm();
  }
  EXPECT_EQ(length, 4.0 * (2.0 + 4.0 + 6.0));
}

TEST(ProjectedLines, GoFromEndToEndOfALineInFront) {
  const Eigen::Vector3d from(-0.5, 0.2, 2.0);
  const Eigen::Vector3d to(0.8, -0.1, 5.0);
  const auto lines = projectLine(Projector(plainCamera()), from, to);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_LT((lines[0].front() - plainPixel(from)).norm(), 1e-9);
  EXPECT_LT((lines[0].back() - plainPixel(to)).norm(), 1e-9);
}

// It begins behind the camera and crosses its plane: what is drawn ends 10,000 pixels off.
TEST(ProjectedLines, LeaveOutWhatIsBehindTheCamera) {
  const Eigen::Vector3d from(0.1, 0.0, -1.0);
  const Eigen::Vector3d to(0.1, 0.0, 4.0);
  const auto lines = projectLine(Projector(plainCamera()), from, to);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_LT((lines[0].back() - plainPixel(to)).norm(), 1e-9);
  EXPECT_NEAR(lines[0].front().x(), 10000.0, 1.0);
  for (const Eigen::Vector2d& pixel : lines[0]) {
    EXPECT_NEAR(pixel.y(), 240.0, 1e-9);
    EXPECT_GT(pixel.x(), 320.0);
  }
  EXPECT_TRUE(projectLine(Projector(plainCamera()), {0, 0, -1}, {1, 0, -2}).empty());
}

TEST(ProjectedLines, ABoxAroundTheCameraIsSeenInPart) {
  const auto lines = projectEdges(Projector(plainCamera()), {{-1, -1, -1}, {1, 1, 2}});
  EXPECT_EQ(lines.size(), 8U); // four edges of the far face, four that lead to it
  const Eigen::Vector2d corner = plainPixel({1, 1, 2});
  EXPECT_EQ(std::ranges::count_if(lines,
                                  [&](const ImageLine& line) {
                                    return (line.back() - corner).norm() < 1e-6 ||
                                           (line.front() - corner).norm() < 1e-6;
                                  }),
            3);
}

TEST(ProjectedLines, BendWithTheLens) {
  Camera camera = plainCamera();
  camera.distortion = {-0.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  const auto lines = projectLine(Projector(camera), {-1.0, 0.8, 2.5}, {1.0, 0.8, 2.5});
  ASSERT_EQ(lines.size(), 1U);
  // Barrel distortion: a line below the center hangs through, by r² of the normalized radius.
  const double middle = 240.0 + 500.0 * 0.32 * (1.0 - 0.2 * 0.32 * 0.32);
  const double end = 240.0 + 500.0 * 0.32 * (1.0 - 0.2 * (0.32 * 0.32 + 0.4 * 0.4));
  EXPECT_NEAR(lines[0][lines[0].size() / 2].y(), middle, 1e-6);
  EXPECT_NEAR(lines[0].front().y(), end, 1e-6);
  EXPECT_NEAR(lines[0].back().y(), end, 1e-6);
}

// The ray of a camera 1 m to the right, seen by the other: from where that camera is, which is
// beyond the image, to the vanishing point of its direction.
TEST(ProjectedLines, OfARayEndAtItsVanishingPoint) {
  const Ray ray{{1.0, 0.0, 0.0}, Eigen::Vector3d(-0.3, 0.1, 1.0).normalized()};
  const auto lines = projectRay(Projector(plainCamera()), ray);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_LT((lines[0].back() - plainPixel({-0.3, 0.1, 1.0})).norm(), 1.0); // 1000 m, not endless
  for (const double depth : {0.5, 2.0, 7.0}) {
    const Eigen::Vector2d on = plainPixel(ray.origin + depth * ray.direction);
    double nearest = 1e9; // of the strokes
    for (std::size_t k = 1; k < lines[0].size(); ++k) {
      const Eigen::Vector2d from = lines[0][k - 1];
      const Eigen::Vector2d way = lines[0][k] - from;
      const double share = std::clamp((on - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (on - from - share * way).norm());
    }
    EXPECT_LT(nearest, 1e-6) << depth;
  }
}

} // namespace
} // namespace dewpoint::tests
