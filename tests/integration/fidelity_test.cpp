// SPDX-License-Identifier: GPL-3.0-or-later
// What of Barrera et al. 2005, section III, method barrera reproduces (docs/fidelity.md). The
// seeds are fixed, so a run repeats exactly on one machine; the bounds leave room for what another
// compiler's rounding does to single runs. "Measured" is `dewpoint-cli experiment convergence
// --seed 1`: 1500 runs per case. A run has converged when its cloud has (convergenceIteration());
// "within" counts those of them that are then less than 3 cm from the ball.
#include "app/wiring/open_project.h"
#include "core/experiment/studies/convergence_study.h"
#include "core/session/run/tracking_run.h"
#include "core/tracking/catalog/method_catalog.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

constexpr int kRuns = 40; // a share of p has a standard error of at most 8 %

ConvergenceResult studied(const std::string& nameBegin) {
  for (const auto& setup : barreraConvergenceCases(kRuns)) {
    if (setup.name.rfind(nameBegin, 0) == 0) {
      return studyConvergence(setup).value();
    }
  }
  ADD_FAILURE() << "no case " << nameBegin;
  return {};
}

TEST(Fidelity, ConvergesFromThePapersStart) {
  const auto result = studied("paper start, ball at 0.5 0.5 0.15");
  EXPECT_GE(result.convergedRunCount, 39);      // measured: all
  EXPECT_GE(result.accurateRunCount, 39);       // the paper: below 3 cm
  EXPECT_GE(result.medianIterations, 10);       // measured: 16
  EXPECT_LE(result.medianIterations, 25);       //
  EXPECT_LE(result.rmse, 0.007);                // measured: 4.3 mm
  EXPECT_LE(std::abs(result.depthBias), 0.004); // measured: 1.0 mm
}

TEST(Fidelity, AFartherBallTakesLonger) {
  const auto result = studied("paper start, ball at 0.8 0.7 0.15");
  EXPECT_GE(result.convergedRunCount, 36); // measured: 99 % within 150 iterations
  EXPECT_GE(result.accurateRunCount, 36);  // and all of them below 3 cm
  EXPECT_GE(result.medianIterations, 30);  // measured: 42; the paper's figure shows about 60
  EXPECT_LE(result.medianIterations, 60);
  EXPECT_LE(result.rmse, 0.015); // measured: 7.2 mm
}

TEST(Fidelity, ABallAMeterAwayTakesThePapersTime) {
  // The paper's figure 3 shows convergence at about iteration 60. Measured: 55, all of 100 runs,
  // with the ball 1 m away, whether or not camera 1 sees the start.
  for (const char* name : {"paper start, ball at 0.6 1.05 0.15", "paper start, figure 3"}) {
    const auto result = studied(name);
    EXPECT_GE(result.convergedRunCount, 36) << name;
    EXPECT_GE(result.accurateRunCount, 36) << name;
    EXPECT_GE(result.medianIterations, 45) << name;
    EXPECT_LE(result.medianIterations, 70) << name;
  }
}

TEST(Fidelity, ABallThatOneCameraSeesHasNoSureDepth) {
  // Camera 2's image ends just before (0.7, 0.75, 0.15): the cloud comes to rest between camera 1's
  // ray and that end, about 3 cm from the ball.
  const auto result = studied("paper start, ball at 0.7 0.75 0.15");
  EXPECT_LE(result.accurateRunCount, 30);
  EXPECT_TRUE(result.convergedRunCount == 0 || result.rmse > 0.015);
}

TEST(Fidelity, AStartBeyondTheBallIsLost) {
  EXPECT_LE(studied("start beyond the ball").convergedRunCount, 4); // measured: 4 %
}

TEST(Fidelity, AUniformStartDependsOnItsVolume) {
  const int desk = studied("uniform start, desk").convergedRunCount;
  const int room = studied("uniform start, room").convergedRunCount;
  EXPECT_GE(desk, 17); // measured: 66 %; three standard errors of 7.4 %
  EXPECT_LE(desk, 36);
  EXPECT_LE(room, 7); // measured: 6 %; three standard errors of 3.8 %
}

TEST(Fidelity, DriftsAwayFromASingleCamera) {
  // Diffusion along the cone of what is seen: further away there is more room. It grows with the
  // cloud. What it is: docs/fidelity.md.
  const double early = measureDrift(20, 5).value();
  const double late = measureDrift(20, 40).value();
  EXPECT_GE(early, 0.003);
  EXPECT_LE(early, 0.010);
  EXPECT_GE(late, 0.007);
  EXPECT_LE(late, 0.018);
  EXPECT_GT(late, early);
}

TEST(Fidelity, AStartBeyondTheBallConvergesWhereBothCamerasSeeIt) {
  auto setup = barreraConvergenceCases(kRuns).front();
  setup.startPosition = {0.5, 0.6, 0.15}; // 10 cm beyond; camera 2 sees up to about y = 0.65 there
  EXPECT_GE(studyConvergence(setup).value().convergedRunCount, 39); // measured: 100 of 100
}

TEST(Fidelity, OnItsWayTheCloudIsLongestAlongCamera1sAxis) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    auto inputs = openProject("still").value(); // starts at the paper's (0.4, 0.1, 0.2)
    inputs.project.method = "barrera";
    inputs.project.parameters = ParameterValues(methodParameters("barrera"));
    inputs.project.parameters.markAllAsGiven();
    const Eigen::Vector3d axis = rigOf(inputs.project)[0].opticalAxis();
    auto run = TrackingRun::create(inputs.project, 1).value();
    run.restart(seed);
    int onTheWay = 0;
    for (int k = 0; k < 40; ++k) {
      run.beginFrame(inputs.source->next().value());
      run.iterateTimed();
      const auto estimate = std::get<SphereEstimate>(run.estimate(0));
      // Between start and ball (at y = 0.5), past the first steps, in which the cloud is still
      // round.
      if (estimate.mean.y() > 0.25 && estimate.mean.y() < 0.45) {
        ++onTheWay;
        const double share = axis.dot(estimate.covariance * axis) / estimate.covariance.trace();
        EXPECT_GT(share, 0.5) << "iteration " << k; // round: 1/3; measured: 0.71 to 0.94
      }
    }
    EXPECT_GE(onTheWay, 2); // it slides, it does not jump
    EXPECT_NEAR(std::get<SphereEstimate>(run.estimate(0)).mean.y(), 0.5, 0.03);
  }
}

} // namespace
} // namespace dewpoint::tests
