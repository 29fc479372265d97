// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/row_heights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace dewpoint::tests {
namespace {

/// Whether some rows at the beginning, and some at the end, fill the visible height exactly.
bool isWholeAtBothEnds(const std::vector<int>& heights, int visible) {
  std::vector<int> down(heights.size());
  std::vector<int> up(heights.size());
  std::partial_sum(heights.begin(), heights.end(), down.begin());
  std::partial_sum(heights.rbegin(), heights.rend(), up.begin());
  return std::ranges::find(down, visible) != down.end() &&
         std::ranges::find(up, visible) != up.end();
}

TEST(RowHeights, RowsThatFitNeedNone) {
  EXPECT_TRUE(heightsForWholeRows({40, 30, 30}, 100).empty());
  EXPECT_TRUE(heightsForWholeRows({}, 100).empty());
}

TEST(RowHeights, TheFirstRowsFillWhatIsVisible) {
  const std::vector<int> heights = heightsForWholeRows({40, 40, 40, 40}, 100);
  EXPECT_EQ(heights, (std::vector{50, 50, 50, 50})); // the last two as well
}

TEST(RowHeights, NoRowIsCutAtEitherEnd) {
  const std::vector<std::vector<int>> stacks{
      {76, 56, 40, 40, 40}, {76, 56, 40, 72, 40, 40, 40}, {40, 76}, {30, 30, 30, 90}, {90, 30, 30}};
  for (const std::vector<int>& least : stacks) {
    const int all = std::accumulate(least.begin(), least.end(), 0);
    for (int visible = std::max(least.front(), least.back()); visible < all; ++visible) {
      const std::vector<int> heights = heightsForWholeRows(least, visible);
      ASSERT_EQ(heights.size(), least.size());
      EXPECT_TRUE(isWholeAtBothEnds(heights, visible)) << visible;
      for (std::size_t k = 0; k < least.size(); ++k) {
        EXPECT_GE(heights[k], least[k]) << visible;
      }
    }
  }
}

TEST(RowHeights, TooLittleRoomForOneRowIsNotDivided) {
  EXPECT_EQ(heightsForWholeRows({76, 40}, 60), (std::vector{76, 40}));
}

} // namespace
} // namespace dewpoint::tests
