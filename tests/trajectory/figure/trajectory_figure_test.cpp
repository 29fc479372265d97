// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/figure/trajectory_figure.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// One target at x = 0, 1, 2 ... with a gap in row 2; y = 10 x, z = 1.
ExportTable tableWithGap() {
  ExportTable table;
  table.targets = {"ball"};
  table.cells.resize(1);
  for (int row = 0; row < 5; ++row) {
    table.times.push_back(0.5 * row);
    ExportCell& cell = table.cells[0].emplace_back();
    cell.hasPosition = row != 2;
    cell.position = Eigen::Vector3d(row, 10.0 * row, 1.0);
    if (row < 2) {
      cell.covariance = Eigen::Vector3d(0.01, 0.04, 0.0).asDiagonal(); // 0.1 and 0.2
    }
  }
  return table;
}

TEST(TrajectoryFigure, AnAxisIsNeverWithoutSize) {
  AxisRange range;
  EXPECT_EQ(range.padded().low, 0.0); // nothing is known
  EXPECT_EQ(range.padded().high, 1.0);
  range.include(3.0);
  EXPECT_EQ(range.padded().low, 2.5);
  EXPECT_EQ(range.padded().high, 3.5);
  range.include(5.0);
  EXPECT_DOUBLE_EQ(range.padded().low, 2.9); // a twentieth of 2
  EXPECT_DOUBLE_EQ(range.padded().high, 5.1);
}

TEST(TrajectoryFigure, GridLinesAreRound) {
  EXPECT_DOUBLE_EQ(gridLineSpacing(5.0), 1.0);
  EXPECT_DOUBLE_EQ(gridLineSpacing(10.0), 2.0);
  EXPECT_DOUBLE_EQ(gridLineSpacing(0.03), 0.005);
  EXPECT_DOUBLE_EQ(gridLineSpacing(4000.0), 1000.0);
  const auto lines = gridLineValues({-1.2, 2.9});
  ASSERT_EQ(lines.size(), 4U); // -1, 0, 1, 2
  EXPECT_DOUBLE_EQ(lines.front(), -1.0);
  EXPECT_DOUBLE_EQ(lines.back(), 2.0);
}

TEST(TrajectoryFigure, EqualScaleWidensTheShorterRange) {
  // 4 over 2 wide is the coarser one: 2 per unit; the height of 3 then shows 6, about 1.5.
  const auto [across, along] = withEqualScale({0.0, 4.0}, {1.0, 2.0}, 2.0, 3.0);
  EXPECT_DOUBLE_EQ(across.low, 0.0);
  EXPECT_DOUBLE_EQ(across.high, 4.0);
  EXPECT_DOUBLE_EQ(along.low, -1.5);
  EXPECT_DOUBLE_EQ(along.high, 4.5);
}

TEST(TrajectoryFigure, CurvesEndAtGapsAndBandsAreTwoSigmas) {
  const TrajectoryFigure figure = computeTrajectoryFigure(tableWithGap());
  const FigurePanel& y = figure.panelsOverTime[1];
  ASSERT_EQ(y.curves.size(), 2U);
  const std::vector<Eigen::Vector2d> path{{0.0, 0.0}, {0.5, 10.0}};
  EXPECT_EQ(y.curves[0].path, path);
  const std::vector<Eigen::Vector2d> band{{0.0, 0.4}, {0.5, 10.4}, {0.5, 9.6}, {0.0, -0.4}};
  ASSERT_EQ(y.curves[0].uncertaintyBand.size(), band.size());
  for (std::size_t k = 0; k < band.size(); ++k) {
    EXPECT_NEAR((y.curves[0].uncertaintyBand[k] - band[k]).norm(), 0.0, 1e-12) << k;
  }
  EXPECT_EQ(y.curves[1].path.front(), Eigen::Vector2d(1.5, 30.0));
  EXPECT_DOUBLE_EQ(y.horizontalRange.high, 2.1); // time: 0 to 2 s and a twentieth
  EXPECT_DOUBLE_EQ(figure.panelsOverTime[2].verticalRange.low, 0.5);
}

TEST(TrajectoryFigure, FromAboveShowsTheFloorInOneScale) {
  ExportTable table = tableWithGap();
  const FigurePanel above = computeTrajectoryFigure(table).topViewPanel;
  EXPECT_EQ(above.horizontalAxis, 0);
  EXPECT_EQ(above.verticalAxis, 1);
  EXPECT_DOUBLE_EQ(above.horizontalRange.size(), above.verticalRange.size());
  EXPECT_EQ(above.curves[1].path.back(), Eigen::Vector2d(4.0, 40.0));
  EXPECT_TRUE(above.curves[0].uncertaintyBand.empty());
  table.axes = WorldAxes::YUp; // the floor is z and x
  EXPECT_EQ(computeTrajectoryFigure(table).topViewPanel.horizontalAxis, 2);
  EXPECT_EQ(computeTrajectoryFigure(table).topViewPanel.verticalAxis, 0);
}

} // namespace
} // namespace dewpoint::tests
