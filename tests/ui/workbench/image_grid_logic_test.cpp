// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/image_grid.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <vector>

namespace dewpoint::tests {
namespace {

constexpr double kWide = 4.0 / 3.0;
constexpr double kTitle = 26.0;

TEST(ImageGrid, TwoImagesStandAsTheyAreLargest) {
  const std::array<double, 2> wide{kWide, kWide};
  EXPECT_EQ(bestImageGrid(wide, {400.0, 700.0}, kTitle).columnCount, 1);  // a narrow column
  EXPECT_EQ(bestImageGrid(wide, {1000.0, 560.0}, kTitle).columnCount, 2); // would be letterboxed
  const std::array<double, 2> upright{kWide, 1.0 / kWide};                // the demo's
  EXPECT_EQ(bestImageGrid(upright, {900.0, 560.0}, kTitle).columnCount, 2);
}

TEST(ImageGrid, ImagesOfARowAreEquallyHighAndFillIt) {
  const std::array<double, 2> aspects{kWide, 1.0 / kWide};
  const ImageGrid grid = imageGridOf(aspects, {2000.0, 300.0 + kTitle}, kTitle, 2);
  EXPECT_NEAR(grid.columnWidthShares[0] / grid.columnWidthShares[1], kWide * kWide, 1e-12);
  EXPECT_NEAR(grid.maximumUsefulWidth, 300.0 * (kWide + 1.0 / kWide), 1e-9);
  EXPECT_NEAR(grid.imageArea, 300.0 * 300.0 * (kWide + 1.0 / kWide), 1e-6);
  // Just as wide as is useful, nothing is left over, and half as wide, half as high.
  const ImageGrid full = imageGridOf(aspects, {grid.maximumUsefulWidth, 300.0 + kTitle}, kTitle, 2);
  EXPECT_NEAR(full.imageArea, grid.imageArea, 1e-6);
  const ImageGrid half =
      imageGridOf(aspects, {grid.maximumUsefulWidth / 2, 300.0 + kTitle}, kTitle, 2);
  EXPECT_NEAR(half.imageArea, grid.imageArea / 4.0, 1e-6);
}

TEST(ImageGrid, SharesAddUp) {
  for (int count = 1; count <= 9; ++count) {
    const std::vector<double> aspects(static_cast<std::size_t>(count), kWide);
    for (int columns = 1; columns <= count; ++columns) {
      const ImageGrid grid = imageGridOf(aspects, {800.0, 600.0}, kTitle, columns);
      ASSERT_EQ(grid.columnWidthShares.size(), static_cast<std::size_t>(columns));
      for (const double share : grid.columnWidthShares) { // one view less makes no wider column
        EXPECT_NEAR(share, 1.0 / columns, 1e-12);
      }
      EXPECT_NEAR(std::accumulate(grid.viewHeightShares.begin(), grid.viewHeightShares.end(), 0.0),
                  columns, 1e-12);
    }
  }
}

TEST(ImageGrid, NineCamerasTile) {
  const std::vector<double> aspects(9, kWide);
  EXPECT_EQ(bestImageGrid(aspects, {900.0, 700.0}, kTitle).columnCount, 3);
}

TEST(ImageGrid, TheGridThereIsStaysUntilAnotherIsWorthIt) {
  const std::array<double, 2> aspects{kWide, kWide};
  // Somewhere between tall and wide, one column and two cover the same.
  const auto room = [](double width) { return QSizeF(width, 600.0); };
  double width = 300.0;
  while (bestImageGrid(aspects, room(width), kTitle).columnCount == 1) {
    width += 1.0;
  }
  EXPECT_EQ(bestImageGrid(aspects, room(width), kTitle, 1).columnCount, 1);
  EXPECT_EQ(bestImageGrid(aspects, room(width - 2.0), kTitle, 2).columnCount, 2);
  EXPECT_EQ(bestImageGrid(aspects, room(2.0 * width), kTitle, 1).columnCount, 2);
  EXPECT_EQ(bestImageGrid(aspects, room(width / 2.0), kTitle, 2).columnCount, 1);
  // Of more columns than there are images by now nothing can be kept.
  EXPECT_EQ(bestImageGrid(std::array{kWide}, room(width), kTitle, 2).columnCount, 1);
}

TEST(ImageGrid, WithoutRoomThereIsAGridAllTheSame) {
  const std::array<double, 3> aspects{kWide, kWide, kWide};
  const ImageGrid grid = bestImageGrid(aspects, {0.0, 10.0}, kTitle);
  EXPECT_EQ(grid.columnCount, 1);
  EXPECT_EQ(grid.imageArea, 0.0);
}

} // namespace
} // namespace dewpoint::tests
