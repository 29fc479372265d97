// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/geometry/convex_hull.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace dewpoint::tests {
namespace {

TEST(ConvexHull, OfACubeIsTheCube) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 8; ++i) {
    points.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  }
  points.emplace_back(0.5, 0.5, 0.5); // inside
  points.emplace_back(0.5, 0.5, 1.0); // on a face
  const ConvexHull hull = convexHull(points);
  EXPECT_EQ(hull.vertices.size(), 8U);
  EXPECT_EQ(hull.faces.size(), 12U); // Euler: two triangles per side
  EXPECT_NEAR(hull.volume(), 1.0, 1e-12);
}

TEST(ConvexHull, OfManyPointsHoldsThemAllAndIsClosed) {
  const RandomStream stream(3, 0, 0, RandomPurpose::Start);
  std::vector<Eigen::Vector3d> points;
  for (std::uint32_t i = 0; i < 800; ++i) {
    const auto normal = stream.normal4(i);
    points.emplace_back(normal[0], 2.0 * normal[1], 0.3 * normal[2]);
  }
  const ConvexHull hull = convexHull(points);
  std::map<std::pair<int, int>, int> edges;
  for (const auto& face : hull.faces) {
    const auto at = [&](std::size_t k) { return hull.vertices[static_cast<std::size_t>(face[k])]; };
    const Eigen::Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0));
    for (const auto& point : points) {
      ASSERT_LE(normal.normalized().dot(point - at(0)), 1e-7);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      ++edges[{face[k], face[(k + 1) % 3]}];
    }
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
  // Euler's formula for triangles: F = 2 V - 4.
  EXPECT_EQ(hull.faces.size(), 2 * hull.vertices.size() - 4);
}

TEST(ConvexHull, OfPointsInAPlaneHasNoVolume) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 20; ++i) {
    points.emplace_back(std::cos(i), std::sin(i), 0.2 * std::cos(i));
  }
  const ConvexHull hull = convexHull(points);
  EXPECT_TRUE(hull.faces.empty());
  EXPECT_EQ(hull.volume(), 0.0);
  EXPECT_TRUE(convexHull(std::vector<Eigen::Vector3d>{}).empty());
}

TEST(ConvexHull, InThePlaneIsCounterclockwiseAndStrict) {
  const auto hull = convexHull(
      std::vector<Eigen::Vector2d>{{0, 0}, {2, 0}, {1, 0}, {2, 1}, {0, 1}, {1, 0.5}, {0, 0.5}});
  const std::vector<Eigen::Vector2d> expected{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  EXPECT_EQ(hull, expected);
}

TEST(ConvexHull, ProjectsAsThePinholeDoes) {
  Camera camera;
  camera.intrinsics = {320, 240, 100.0, 100.0, 160.0, 120.0};
  camera.cameraFromWorld.translation().z() = 2.0; // 2 m in front, axes as the world's
  ConvexHull hull;
  hull.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 0}};
  const auto outline = projectedHull(Projector(camera), hull);
  // 1 m at 2 m and 100 px: 50 px from the middle.
  const std::vector<Eigen::Vector2d> expected{{110, 70}, {210, 70}, {210, 170}, {110, 170}};
  ASSERT_EQ(outline.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_LT((outline[k] - expected[k]).norm(), 1e-9);
  }
}

} // namespace
} // namespace dewpoint::tests
