// SPDX-License-Identifier: GPL-3.0-or-later
// Delays of cameras, estimated from the motion of a target.
#include "core/tracking/dewpoint/clock_estimator.h"
#include "tests/tracking/drawn_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace dewpoint::tests {
namespace {

using drawn::DrawnRun;
using drawn::redBall;
using drawn::rigAround;

constexpr double kMillisecond = 1e-3;

/// Where a ball is that moves at about 1 m/s in all directions.
Eigen::Vector3d movingAt(double time) {
  return drawn::kMiddle + Eigen::Vector3d(0.16 * std::sin(4.1 * time), 0.15 * std::sin(5.3 * time),
                                          0.08 * std::sin(7.7 * time));
}

/// Shows `seconds` of the moving ball; `delayOf(camera, time)` is how late an image is stamped.
template <class DelayOf> void showMotion(DrawnRun& run, double seconds, const DelayOf& delayOf) {
  const std::int64_t end = run.index() + std::lround(30.0 * seconds);
  for (std::int64_t index = run.index(); index < end; ++index) {
    auto set = std::make_shared<FrameSet>();
    set->index = index;
    set->time = timeStamp(static_cast<double>(index) / 30.0);
    for (std::size_t k = 0; k < run.rig().size(); ++k) {
      const double time = static_cast<double>(index) / 30.0;
      auto frame = std::make_shared<Frame>();
      frame->index = index;
      frame->captureTime = set->time;
      frame->image = drawn::draw(run.rig()[k], {{movingAt(time - delayOf(k, time))}});
      drawn::addNoise(frame->image, 3.0, static_cast<std::uint32_t>(index), 99 + k);
      set->frames.push_back(std::move(frame));
    }
    run.showSet(std::move(set));
  }
}

/// The delay of a camera relative to that of the first one.
double relativeDelay(const DrawnRun& run, std::size_t camera) {
  return run.estimateClocks()[camera].delaySeconds;
}

TEST(ClockEstimator, FindsDelaysWithinTwoMilliseconds) {
  const std::vector<double> delays{0.0, 0.024, -0.017};
  DrawnRun run(rigAround(3), {redBall()});
  showMotion(run, 10.0, [&](std::size_t k, double) { return delays[k]; });
  for (std::size_t k = 1; k < delays.size(); ++k) {
    EXPECT_NEAR(relativeDelay(run, k), delays[k], 2.0 * kMillisecond) << k;
    const double sigma = run.estimateClocks()[k].delaySigma;
    EXPECT_LT(sigma, 3.0 * kMillisecond) << k;
    EXPECT_LT(std::abs(relativeDelay(run, k) - delays[k]), 4.0 * sigma) << k;
  }
}

TEST(ClockEstimator, FindsNoDelayWhereThereIsNone) {
  DrawnRun run(rigAround(2), {redBall()});
  showMotion(run, 5.0, [](std::size_t, double) { return 0.0; });
  EXPECT_NEAR(relativeDelay(run, 1), 0.0, 1.0 * kMillisecond);
}

TEST(ClockEstimator, FollowsAClockThatDrifts) {
  const double drift = 1e-3;
  DrawnRun run(rigAround(3), {redBall()});
  showMotion(run, 15.0, [&](std::size_t k, double time) { return k == 2 ? drift * time : 0.0; });
  EXPECT_NEAR(relativeDelay(run, 2), 15.0 * drift, 2.0 * kMillisecond);
  EXPECT_NEAR(run.estimateClocks()[2].drift, drift, 0.5 * drift);
}

TEST(ClockEstimator, EstimatesNothingIfTimesAreExact) {
  DrawnRun run(rigAround(2), {redBall()}, {{"delay_spread", 0.0}});
  showMotion(run, 2.0, [](std::size_t k, double) { return k == 1 ? 0.02 : 0.0; });
  for (const ClockEstimate& clock : run.estimateClocks()) {
    EXPECT_EQ(clock.delaySeconds, 0.0);
    EXPECT_EQ(clock.delaySigma, 0.0);
  }
}

TEST(ClockEstimator, ATargetAtRestSaysNothing) {
  DrawnRun run(rigAround(2), {redBall()});
  for (int index = 0; index < 60; ++index) {
    run.show({{drawn::kMiddle}});
  }
  EXPECT_NEAR(relativeDelay(run, 1), 0.0, 1e-4);
  EXPECT_GT(run.estimateClocks()[1].delaySigma, 10.0 * kMillisecond);
}

TEST(ClockEstimator, MakesPositionsBetter) {
  const auto errorWith = [](double spread) {
    DrawnRun run(rigAround(3), {redBall()}, {{"delay_spread", spread}});
    const auto delayOf = [](std::size_t k, double) { return k == 0 ? 0.02 : -0.01; };
    showMotion(run, 5.0, delayOf);
    double sum = 0.0;
    for (int k = 0; k < 60; ++k) {
      showMotion(run, 1.0 / 30.0, delayOf);
      const double time = static_cast<double>(run.index() - 1) / 30.0;
      sum += (run.estimate().mean - movingAt(time)).squaredNorm();
    }
    return std::sqrt(sum / 60.0);
  };
  EXPECT_LT(errorWith(10.0), 0.7 * errorWith(0.0));
}

TEST(ClockEstimator, AnotherCalibrationStartsAgain) {
  DrawnRun run(rigAround(2), {redBall()});
  showMotion(run, 3.0, [](std::size_t k, double) { return k == 1 ? 0.02 : 0.0; });
  EXPECT_GT(relativeDelay(run, 1), 10.0 * kMillisecond);
  CameraRig moved = run.rig();
  moved[0].intrinsics.focalX += 1.0;
  run.tracker().setCameras(moved);
  EXPECT_EQ(relativeDelay(run, 1), 0.0);
}

/// What each camera of a rig says about a target at `position` that moves with `velocity`, if its
/// images are late by `delays` and it sees the target displaced by a hundredth of the distance.
std::vector<CameraInformation> pullsOf(const CameraRig& rig, const Eigen::Vector3d& position,
                                       const Eigen::Vector3d& velocity,
                                       const std::vector<double>& delays) {
  constexpr double kInformation = 1e6; // 1 mm
  std::vector<CameraInformation> pulls(rig.size());
  for (std::size_t k = 0; k < rig.size(); ++k) {
    const Eigen::Vector3d ray = position - rig[k].center();
    const Eigen::Vector3d along = ray.normalized();
    const Eigen::Vector3d displaced = 0.01 * ray.cross(Eigen::Vector3d::UnitZ());
    pulls[k].information = kInformation * (Eigen::Matrix3d::Identity() - along * along.transpose());
    pulls[k].vector = pulls[k].information * (displaced - delays[k] * velocity);
  }
  return pulls;
}

TEST(ClockEstimator, SeveralTargetsForgetCalibrationErrorsNoFasterThanOne) {
  const CameraRig rig = rigAround(3);
  const auto delaysWith = [&](int others) {
    tracking::ClockEstimator estimator(rig);
    estimator.setPrior({0.01, 0.01});
    for (int index = 0; index < 90; ++index) {
      const double time = index / 30.0;
      const Eigen::Vector3d position = movingAt(time);
      const Eigen::Vector3d velocity = (movingAt(time + 1e-4) - position) / 1e-4;
      const auto pulls = pullsOf(rig, position, velocity, {0.0, 0.008, -0.005});
      std::vector<tracking::ClockEstimator::Sighting> sightings{{position, velocity, &pulls, 1.0}};
      // They move in the same way, but are not clearly seen: they add no information.
      sightings.resize(1 + static_cast<std::size_t>(others), {position, velocity, &pulls, 0.0});
      estimator.learn(sightings, 1.0 / 30.0);
    }
    return estimator.delays();
  };
  const std::vector<double> alone = delaysWith(0);
  EXPECT_GT(std::abs(alone[1] - alone[0]), 1.0 * kMillisecond); // something was learned
  EXPECT_EQ(alone, delaysWith(4));
}

} // namespace
} // namespace dewpoint::tests
