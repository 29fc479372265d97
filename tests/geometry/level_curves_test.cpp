// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/level_curves.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

/// A bell with standard deviation 0.2 m around (1, 2).
GroundGrid bell(double middle = 1.0, int cells = 40) {
  GroundGrid grid;
  grid.origin = {0.0, 1.0};
  grid.step = 2.0 / cells;
  grid.values.resize(cells + 1, cells + 1);
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const Eigen::Vector2d place = grid.origin + grid.step * Eigen::Vector2d(i, j);
      grid.values(i, j) =
          std::exp(-0.5 * (place - Eigen::Vector2d(middle, 2.0)).squaredNorm() / 0.04);
    }
  }
  return grid;
}

TEST(LevelCurves, OfABellAreClosedCircles) {
  const GroundGrid grid = bell();
  // exp(-r²/(2 sigma²)) = 0.5 at r = sigma sqrt(2 ln 2) = 0.2355 m.
  const auto curves = levelCurves(grid, 0.5);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0].front(), curves[0].back());
  for (const auto& point : curves[0]) {
    EXPECT_NEAR((point - Eigen::Vector2d(1.0, 2.0)).norm(), 0.2355, 0.003);
  }
}

TEST(LevelCurves, EndAtTheBorderOfTheGrid) {
  const auto curves = levelCurves(bell(0.0), 0.5); // half of the bell is outside
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_NE(curves[0].front(), curves[0].back());
  EXPECT_NEAR(curves[0].front().x(), 0.0, 1e-12);
  EXPECT_NEAR(curves[0].back().x(), 0.0, 1e-12);
}

TEST(LevelCurves, SeparateAtASaddle) {
  GroundGrid grid;
  grid.values.resize(2, 2);
  grid.values << 1.0, 0.0, 0.0, 1.0;
  EXPECT_EQ(levelCurves(grid, 0.6).size(), 2U);
  EXPECT_EQ(levelCurves(grid, 0.4).size(), 2U);
  EXPECT_TRUE(levelCurves(grid, 2.0).empty());
}

TEST(LevelCurves, LevelsHoldTheirShare) {
  const GroundGrid grid = bell(1.0, 200); // fine, for it is a count of cells
  // Of a round normal distribution the share 1 - exp(-r²/(2 sigma²)) lies within r: half of it
  // where the density is half of its peak.
  EXPECT_NEAR(levelForProbability(grid, 0.5), 0.5, 0.03);
  EXPECT_NEAR(levelForProbability(grid, 0.95), 0.05, 0.01);
}

} // namespace
} // namespace dewpoint::tests
