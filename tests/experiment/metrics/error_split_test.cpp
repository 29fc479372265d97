// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/error_split.h"
#include "tests/base/not_a_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace dewpoint::tests {
namespace {

const Eigen::Vector3d kOrigin = Eigen::Vector3d::Zero();

// Errors (3, 0, 4) and (1, 0, 0), one camera that looks along x (its axis given 2 long).
// rmse = sqrt((25 + 1) / 2) = sqrt(13); bias (2, 0, 2), length² 8; about it (1, 0, 2) and
// (-1, 0, -2), spread sqrt(5), and 8 + 5 = 13. Along: 3 and 1, mean 2, rms sqrt((9 + 1) / 2)
// = sqrt(5). Across: 4 and 0, length of the mean 2, rms sqrt(16 / 2) = sqrt(8), and 5 + 8 = 13.
TEST(ErrorSplit, HandWorked) {
  const std::vector<Eigen::Vector3d> errors{{3.0, 0.0, 4.0}, {1.0, 0.0, 0.0}};
  const ErrorSplit split = splitErrors(errors, {{"one", kOrigin, {2.0, 0.0, 0.0}}});
  EXPECT_EQ(split.errorCount, 2);
  EXPECT_DOUBLE_EQ(split.summary.rmse, std::sqrt(13.0));
  EXPECT_DOUBLE_EQ(split.summary.medianError, 3.0); // lengths 5 and 1
  EXPECT_DOUBLE_EQ(split.summary.p95, 4.8);         // 1 + 0.95 * 4
  EXPECT_DOUBLE_EQ(split.summary.maxError, 5.0);
  EXPECT_TRUE(split.summary.bias.isApprox(Eigen::Vector3d(2.0, 0.0, 2.0)));
  EXPECT_DOUBLE_EQ(split.spread, std::sqrt(5.0));
  ASSERT_EQ(split.cameraBiases.size(), 1U);
  EXPECT_EQ(split.cameraBiases[0].cameraName, "one");
  EXPECT_DOUBLE_EQ(split.cameraBiases[0].alongAxisBias, 2.0);
  EXPECT_DOUBLE_EQ(split.cameraBiases[0].acrossAxisBias, 2.0);
  EXPECT_DOUBLE_EQ(split.cameraBiases[0].alongAxisRms, std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(split.cameraBiases[0].acrossAxisRms, std::sqrt(8.0));
  ASSERT_TRUE(split.meanViewBias.has_value());
  EXPECT_DOUBLE_EQ(split.meanViewBias->alongAxisRms, std::sqrt(5.0)); // of one camera: its own axis
}

// Cameras along x and y see along (1, 1, 0) / sqrt(2) on average: error (1, 1, 1) is sqrt(2) deep
// and 1 lateral.
TEST(ErrorSplit, MeanViewOfTwoCameras) {
  const ErrorSplit split = splitErrors(
      {{1.0, 1.0, 1.0}}, {{"x", kOrigin, {1.0, 0.0, 0.0}}, {"y", kOrigin, {0.0, 1.0, 0.0}}});
  ASSERT_TRUE(split.meanViewBias.has_value());
  EXPECT_NEAR(split.meanViewBias->alongAxisBias, std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(split.meanViewBias->acrossAxisRms, 1.0, 1e-15);
}

TEST(ErrorSplit, CamerasFaceToFaceHaveNoMeanView) {
  const std::vector<TrajectoryCamera> cameras{{"x", kOrigin, {1.0, 0.0, 0.0}},
                                              {"y", kOrigin, {-1.0, 0.0, 0.0}}};
  EXPECT_FALSE(splitErrors({{1.0, 0.0, 0.0}}, cameras).meanViewBias.has_value());
  EXPECT_EQ(splitErrors({{1.0, 0.0, 0.0}}, cameras).cameraBiases.size(), 2U);
  EXPECT_FALSE(splitErrors({{1.0, 0.0, 0.0}}, {}).meanViewBias.has_value());
}

TEST(ErrorSplit, ErrorsThatAreNoNumbersAreLeftOut) {
  const ErrorSplit split = splitErrors({{kNotANumber, 0.0, 0.0}, {0.0, 2.0, 0.0}}, {});
  EXPECT_EQ(split.errorCount, 1);
  EXPECT_EQ(split.summary.rmse, 2.0);
  EXPECT_TRUE(std::isnan(splitErrors({}, {}).summary.rmse));
  EXPECT_EQ(splitErrors({}, {}).errorCount, 0);
}

} // namespace
} // namespace dewpoint::tests
