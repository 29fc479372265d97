// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/convergence_csv.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

constexpr const char* kHead =
    "case,ball_x_m,ball_y_m,ball_z_m,start_x_m,start_y_m,start_z_m,half_x_m,half_y_m,half_z_m,"
    "first_seed,runs,converged,within,median_iterations,rmse_mm,depth_bias_mm\n";

TEST(ConvergenceCsv, HasARowPerCase) {
  ConvergenceResult result;
  result.setup = barreraConvergenceCases(7, kFirstReportingSeed).front();
  result.convergedRunCount = 5;
  result.accurateRunCount = 4;
  result.medianIterations = 16.5;
  result.rmse = 0.0043; // meters
  result.depthBias = -0.001;
  // The first case: the ball at (0.5, 0.5, 0.15), the paper's start (0.4, 0.1, 0.2), a point.
  EXPECT_EQ(convergenceCsv({result}),
            std::string(kHead) + "\"" + result.setup.name + "\"" +
                ",0.5,0.5,0.15,0.4,0.1,0.2,0,0,0,1006001,7,5,4,16.5,4.3,-1\n");
}

TEST(ConvergenceCsv, SaysNothingOfRunsThatThereAreNot) {
  ConvergenceResult result;
  result.setup.name = "none";
  result.setup.ballPosition = result.setup.startPosition = Eigen::Vector3d::Zero();
  result.setup.runCount = 2;
  EXPECT_EQ(convergenceCsv({result}), std::string(kHead) + "none,0,0,0,0,0,0,0,0,0,1,2,0,0,,,\n");
}

TEST(DriftCsv, IsInMillimeters) {
  EXPECT_EQ(driftCsv({{3, 50, 40, 0.0118}}),
            "first_seed,runs,iterations,mm_per_iteration\n3,50,40,11.8\n");
}

} // namespace
} // namespace dewpoint::tests
