// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/projector.h"
#include "core/geometry/reference_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::tests {
namespace {

Camera above(const std::array<double, 8>& distortion = {}) {
  Camera camera;
  camera.intrinsics = {640, 480, 500.0, 500.0, 319.5, 239.5};
  camera.distortion = distortion;
  camera.cameraFromWorld = lookAt({0.0, -3.0, 2.0}, {0.0, 0.0, 0.0});
  return camera;
}

std::size_t count(const std::vector<GridLine>& lines, GridRole role) {
  return static_cast<std::size_t>(std::ranges::count(lines, role, &GridLine::role));
}

TEST(ReferenceGrid, AFloorHasItsLinesBordersAndAxes) {
  const ReferenceGrid grid{GridKind::Floor, {2.0, 1.0, 9.0}, 0.5, {1.0, 2.0, 0.0}, 0.0};
  const auto lines = gridLines(grid);
  // Across y: at 0.5 (1 is the border); across x: at 0.5, 1, 1.5 (2 is the border).
  EXPECT_EQ(count(lines, GridRole::Line), 4U);
  EXPECT_EQ(count(lines, GridRole::Border), 2U);
  EXPECT_EQ(count(lines, GridRole::AxisX), 1U);
  EXPECT_EQ(count(lines, GridRole::AxisY), 1U);
  EXPECT_EQ(count(lines, GridRole::AxisZ), 0U);
  for (const GridLine& line : lines) {
    EXPECT_EQ(line.from.z(), 0.0);
    EXPECT_GE(line.from.x(), 1.0);
    EXPECT_LE(line.to.x(), 3.0);
    EXPECT_LE(line.to.y(), 3.0);
  }
}

TEST(ReferenceGrid, AWallStandsAndABoxHasTwelveEdges) {
  const ReferenceGrid wall{GridKind::Wall, {2.0, 9.0, 1.0}, 1.0, {0, 0, 0}, M_PI / 2};
  for (const GridLine& line : gridLines(wall)) {
    EXPECT_NEAR(line.from.x(), 0.0, 1e-12) << "turned by a quarter, the wall lies in y and z";
  }
  const ReferenceGrid box{GridKind::Box, {1.0, 1.0, 1.0}, 1.0, {0, 0, 0}, 0.0};
  const auto lines = gridLines(box);
  EXPECT_EQ(count(lines, GridRole::Line), 0U);
  // Three axes, six borders of the sides and three edges that no side has.
  EXPECT_EQ(lines.size(), 12U);
}

TEST(ReferenceGrid, LabelsSayMetersAndAxes) {
  const auto labels = gridLabels({GridKind::Floor, {1.0, 0.5, 1.0}, 0.5, {0, 0, 0}, 0.0});
  ASSERT_EQ(labels.size(), 3U);
  EXPECT_EQ(labels[0].text, "0.5");
  EXPECT_EQ(labels[1].text, "x 1 m");
  EXPECT_EQ(labels[2].text, "y 0.5 m");
  EXPECT_LT((labels[1].at - Eigen::Vector3d(1, 0, 0)).norm(), 1e-12);
  EXPECT_LE(gridLabels({GridKind::Floor, {10.0, 10.0, 1.0}, 0.1, {0, 0, 0}, 0.0}).size(), 22U);
}

TEST(ReferenceGrid, StrokesStayInTheImageAndOnTheCurve) {
  for (const auto& bend : {std::array<double, 8>{}, std::array<double, 8>{-0.28, 0.07}}) {
    const Camera camera = above(bend);
    const ReferenceGrid grid;
    const auto seen = projectGrid(camera, grid);
    ASSERT_GT(seen.strokes.size(), 10U);
    const Projector projector(camera);
    std::vector<Eigen::Vector2d> truth; // all lines, point by point
    for (const GridLine& line : gridLines(grid)) {
      for (int k = 0; k <= 4000; ++k) {
        if (const auto at = projector.project(line.from + k / 4000.0 * (line.to - line.from))) {
          truth.push_back(*at);
        }
      }
    }
    for (const GridStroke& stroke : seen.strokes) {
      ASSERT_GE(stroke.points.size(), 2U);
      for (std::size_t k = 0; k + 1 < stroke.points.size(); ++k) {
        const Eigen::Vector2d middle = 0.5 * (stroke.points[k] + stroke.points[k + 1]);
        EXPECT_GE(middle.minCoeff(), -0.5 - 1e-9);
        EXPECT_LE(middle.x(), 639.5 + 1e-9);
        EXPECT_LE(middle.y(), 479.5 + 1e-9);
        double nearest = 1e9;
        for (const Eigen::Vector2d& at : truth) {
          nearest = std::min(nearest, (at - middle).norm());
        }
        EXPECT_LT(nearest, 0.45); // 0.2 px of bend, and the spacing of the true points
      }
    }
  }
}

TEST(ReferenceGrid, NothingBehindTheCameraIsDrawn) {
  Camera camera = above();
  camera.cameraFromWorld = lookAt({0.0, -3.0, 2.0}, {0.0, -6.0, 2.5}); // its back to the grid
  EXPECT_TRUE(projectGrid(camera, ReferenceGrid()).strokes.empty());
  camera.cameraFromWorld = lookAt({0.0, 0.0, 0.5}, {0.0, 2.0, 0.4}); // in the middle of it
  const auto seen = projectGrid(camera, ReferenceGrid());
  EXPECT_FALSE(seen.strokes.empty());
  for (const GridStroke& stroke : seen.strokes) {
    for (const Eigen::Vector2d& point : stroke.points) {
      EXPECT_TRUE(point.allFinite());
    }
  }
}

TEST(ReferenceGrid, APixelMeansTheCrossingTheSurfaceOrTheRay) {
  const Camera camera = above();
  const ReferenceGrid grid;
  const Projector projector(camera);
  const Eigen::Vector3d crossing(0.5, 0.5, 0.0); // 2.5 m along both axes: a multiple of the step
  const Eigen::Vector2d pixel = *projector.project(crossing);
  const auto snapped = gridPointAt(camera, grid, pixel + Eigen::Vector2d(3.0, 2.0), 6.0);
  ASSERT_TRUE(snapped);
  EXPECT_LT((*snapped - crossing).norm(), 1e-12);
  const auto surface = gridPointAt(camera, grid, pixel + Eigen::Vector2d(20.0, 9.0), 6.0);
  ASSERT_TRUE(surface);
  EXPECT_NEAR(surface->z(), 0.0, 1e-9);
  EXPECT_LT((*projector.project(*surface) - pixel - Eigen::Vector2d(20.0, 9.0)).norm(), 1e-6);
  Camera up = camera;
  up.cameraFromWorld = lookAt({0.0, -3.0, 2.0}, {0.0, 0.0, 5.0}); // sees no floor
  const auto somewhere = gridPointAt(up, grid, {320.0, 240.0}, 6.0);
  ASSERT_TRUE(somewhere);
  EXPECT_NEAR((*somewhere - up.center()).norm(), (grid.center() - up.center()).norm(), 1e-9);
}

TEST(ReferenceGrid, ChecksWhatCanBeDrawn) {
  EXPECT_TRUE(checkGrid(ReferenceGrid()));
  ReferenceGrid grid;
  grid.step = 0.0;
  EXPECT_EQ(checkGrid(grid).error().field, "step");
  grid = {};
  grid.size.x() = -1.0;
  EXPECT_EQ(checkGrid(grid).error().field, "size");
  grid = {};
  grid.step = 0.001;
  EXPECT_EQ(checkGrid(grid).error().field, "step") << "4000 lines";
  grid = {};
  grid.size.z() = 1000.0;
  EXPECT_TRUE(checkGrid(grid)) << "a floor has no height";
  grid.origin.x() = std::nan("");
  EXPECT_EQ(checkGrid(grid).error().field, "origin");
}

} // namespace
} // namespace dewpoint::tests
