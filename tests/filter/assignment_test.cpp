// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/filter/assignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace dewpoint::tests {
namespace {

constexpr double kForbidden = std::numeric_limits<double>::infinity();
using Columns = std::vector<Eigen::Index>;

/// Every way to give rows columns (or none): most pairs, then least cost.
void tryAll(const Eigen::MatrixXd& cost, Eigen::Index row, std::set<Eigen::Index>& used,
            Assignment current, Assignment& best) {
  if (row == cost.rows()) {
    if (current.pairCount > best.pairCount ||
        (current.pairCount == best.pairCount && current.cost < best.cost))
      best = current;
    return;
  }
  tryAll(cost, row + 1, used, current, best);
  for (Eigen::Index column = 0; column < cost.cols(); ++column) {
    if (!std::isfinite(cost(row, column)) || !used.insert(column).second)
      continue;
    Assignment next = current;
    ++next.pairCount;
    next.cost += cost(row, column);
    tryAll(cost, row + 1, used, next, best);
    used.erase(column);
  }
}

Assignment bruteForce(const Eigen::MatrixXd& cost) {
  Assignment best;
  best.pairCount = -1;
  std::set<Eigen::Index> used;
  tryAll(cost, 0, used, Assignment{}, best);
  return best;
}

// The six permutations cost 1 + 1 + 9 = 11, 1 + 5 + 8 = 14, 2 + 4 + 9 = 15, 2 + 5 + 1 = 8,
// 3 + 4 + 8 = 15 and 3 + 1 + 1 = 5.
TEST(Assignment, HandWorkedSquare) {
  Eigen::MatrixXd cost(3, 3);
  cost << 1, 2, 3, 4, 1, 5, 1, 8, 9;
  const Assignment result = assignMinimumCost(cost);
  EXPECT_EQ(result.columnOfRow, (Columns{2, 1, 0}));
  EXPECT_EQ(result.cost, 5.0); // 3 + 1 + 1
  EXPECT_EQ(result.pairCount, 3);
}

// Two rows, three columns: both want column 1 (cost 1 and 2); 1 + 4 = 5 against 3.5 + 2 = 5.5 for
// the other way round.
TEST(Assignment, RectangularBothWays) {
  Eigen::MatrixXd cost(2, 3);
  cost << 3.5, 1, 7, 9, 2, 4;
  const Assignment wide = assignMinimumCost(cost);
  EXPECT_EQ(wide.columnOfRow, (Columns{1, 2}));
  EXPECT_EQ(wide.cost, 5.0);
  const Assignment tall = assignMinimumCost(cost.transpose());
  EXPECT_EQ(tall.columnOfRow, (Columns{kUnassigned, 0, 1}));
  EXPECT_EQ(tall.cost, 5.0);
  EXPECT_EQ(tall.pairCount, 2);
}

// Rows 0 and 1 may only have column 0: the cheaper one gets it, whichever comes first.
TEST(Assignment, ForbiddenPairsLeaveTheDearerRowOut) {
  Eigen::MatrixXd cost(2, 2);
  cost << 5, kForbidden, 1, kForbidden;
  EXPECT_EQ(assignMinimumCost(cost).columnOfRow, (Columns{kUnassigned, 0}));
  EXPECT_EQ(assignMinimumCost(cost).cost, 1.0);
  cost << 1, kForbidden, 5, kForbidden;
  EXPECT_EQ(assignMinimumCost(cost).columnOfRow, (Columns{0, kUnassigned}));
}

// More pairs come before less cost: two pairs of 1000 + 1000 beat one pair of 1.
TEST(Assignment, PairsComeBeforeCost) {
  Eigen::MatrixXd cost(2, 2);
  cost << 1, 1000, 1000, std::numeric_limits<double>::quiet_NaN();
  const Assignment result = assignMinimumCost(cost);
  EXPECT_EQ(result.columnOfRow, (Columns{1, 0}));
  EXPECT_EQ(result.cost, 2000.0);
}

TEST(Assignment, EmptyAndAllForbidden) {
  EXPECT_TRUE(assignMinimumCost(Eigen::MatrixXd(0, 0)).columnOfRow.empty());
  EXPECT_TRUE(assignMinimumCost(Eigen::MatrixXd(0, 3)).columnOfRow.empty());
  EXPECT_EQ(assignMinimumCost(Eigen::MatrixXd(2, 0)).columnOfRow,
            (Columns{kUnassigned, kUnassigned}));
  const Assignment none = assignMinimumCost(Eigen::MatrixXd::Constant(2, 3, kForbidden));
  EXPECT_EQ(none.columnOfRow, (Columns{kUnassigned, kUnassigned}));
  EXPECT_EQ(none.pairCount, 0);
  EXPECT_EQ(none.cost, 0.0);
}

TEST(Assignment, TiesAreDecidedTheSameWayEachTime) {
  const Eigen::MatrixXd cost = Eigen::MatrixXd::Constant(3, 3, 2.0);
  const Assignment first = assignMinimumCost(cost);
  EXPECT_EQ(first.cost, 6.0);
  EXPECT_EQ(assignMinimumCost(cost).columnOfRow, first.columnOfRow);
}

// Costs (i + 1)(j + 1): the sum is least with the largest factors against the smallest
// (rearrangement inequality), row i with column 49 - i: the sum of i (51 - i) for i = 1 to 50 is
// 51 * 1275 - 42925 = 22100. Thirty dearer columns change nothing.
TEST(Assignment, FiftyRows) {
  for (const Eigen::Index columns : {50, 80}) {
    const Eigen::VectorXd rowFactor = Eigen::VectorXd::LinSpaced(50, 1.0, 50.0);
    const Eigen::VectorXd columnFactor =
        Eigen::VectorXd::LinSpaced(columns, 1.0, static_cast<double>(columns));
    const Assignment result = assignMinimumCost(rowFactor * columnFactor.transpose());
    EXPECT_DOUBLE_EQ(result.cost, 22100.0);
    for (Eigen::Index row = 0; row < 50; ++row)
      EXPECT_EQ(result.columnOfRow[static_cast<std::size_t>(row)], 49 - row);
  }
}

// 2,000 random matrices of 0 to 5 rows and columns; costs are whole numbers from -20 to 20 (sums
// are exact, ties frequent), each pair forbidden with a probability that also varies.
TEST(Assignment, AgreesWithBruteForce) {
  const RandomStream random(7, 0, 0, RandomPurpose::Noise);
  for (std::uint32_t trial = 0; trial < 2000; ++trial) {
    const auto word = random.randomWords(trial);
    Eigen::MatrixXd cost(word[0] % 6, word[1] % 6);
    const double share = (word[2] % 4) * 0.25;
    for (Eigen::Index k = 0; k < cost.size(); ++k) {
      const auto draw = random.uniform3(trial, static_cast<std::uint32_t>(k) + 1);
      cost.data()[k] = draw[0] < share ? kForbidden : std::floor(draw[1] * 41.0) - 20.0;
    }
    const Assignment best = bruteForce(cost);
    const Assignment found = assignMinimumCost(cost);
    ASSERT_EQ(found.pairCount, best.pairCount) << cost;
    ASSERT_EQ(found.cost, best.cost) << cost;
    std::set<Eigen::Index> used;
    for (const Eigen::Index column : found.columnOfRow)
      ASSERT_TRUE(column == kUnassigned || used.insert(column).second) << cost;
  }
}

} // namespace
} // namespace dewpoint::tests
