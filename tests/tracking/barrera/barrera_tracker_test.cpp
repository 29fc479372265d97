// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/thread_team.h"
#include "core/tracking/barrera/barrera_parameters.h"
#include "core/tracking/barrera/barrera_tracker.h"
#include "tests/tracking/drawn_run.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <cmath>
#include <memory>

namespace dewpoint::tests {
namespace {

using drawn::kRadius;
using drawn::redBall;

const Eigen::Vector3d kBallCenter(0.5, 0.5, 0.15);

/// The cameras of Barrera et al. 2005, camera 2 in portrait. The paper gives neither their
/// directions nor focal lengths: along +y and +x, which both see the ball, and 300 px, usual for a
/// webcam.
CameraRig barreraRig() {
  CameraRig rig(2);
  rig[0].intrinsics = {320, 240, 300.0, 300.0, 159.5, 119.5};
  const Eigen::Vector3d first(0.5, 0.0, 0.195);
  rig[0].cameraFromWorld = lookAt(first, first + Eigen::Vector3d::UnitY());
  rig[1].intrinsics = {240, 320, 300.0, 300.0, 119.5, 159.5};
  const Eigen::Vector3d second(0.07, 0.485, 0.085);
  rig[1].cameraFromWorld = lookAt(second, second + Eigen::Vector3d::UnitX());
  return rig;
}

/// A red disk where the ball is, on white.
FramePtr ballFrame(const Camera& camera, const Eigen::Vector3d& ball) {
  auto frame = std::make_shared<Frame>();
  const Intrinsics& in = camera.intrinsics;
  frame->image = cv::Mat(in.height, in.width, CV_8UC3, cv::Scalar(255, 255, 255));
  const Eigen::Vector2d center = *Projector(camera).project(ball);
  const double radius = in.focalX * kRadius / (camera.cameraFromWorld * ball).z();
  for (int row = 0; row < in.height; ++row) {
    for (int column = 0; column < in.width; ++column) {
      if (std::hypot(column - center.x(), row - center.y()) < radius) {
        frame->image.at<cv::Vec3b>(row, column) = cv::Vec3b(0, 0, 255);
      }
    }
  }
  return frame;
}

FrameSetPtr ballFrames(const CameraRig& rig, const Eigen::Vector3d& ball, std::int64_t index = 0) {
  auto set = std::make_shared<FrameSet>();
  set->index = index;
  for (const Camera& camera : rig) {
    set->frames.push_back(ballFrame(camera, ball));
  }
  return set;
}

ParameterValues parameters(std::initializer_list<std::pair<const char*, double>> changes = {}) {
  ParameterValues values(barreraParameters());
  for (const auto& [key, value] : changes) {
    EXPECT_TRUE(values.set(key, value)) << key;
  }
  return values;
}

std::unique_ptr<BarreraTracker> startedBarrera(const ParameterValues& values, const CameraRig& rig,
                                               std::uint64_t seed = 1) {
  auto tracker = std::make_unique<BarreraTracker>(values, rig, redBall());
  tracker->restart(seed);
  return tracker;
}

// The start of the paper is (0.4, 0.1, 0.2); it reports an error below 3 cm once converged (at
// about iteration 60; 100 leaves room).
TEST(BarreraTracker, ConvergesFromThePapersStart) {
  const CameraRig rig = barreraRig();
  ThreadTeam team;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto tracker = startedBarrera(parameters(), rig, seed);
    tracker->beginFrame(ballFrames(rig, kBallCenter));
    SphereEstimate estimate;
    for (int iteration = 0; iteration < 100; ++iteration) {
      estimate = tracker->iterate(team);
    }
    EXPECT_LT((estimate.mean - kBallCenter).norm(), 0.03) << "seed " << seed;
    EXPECT_EQ(estimate.seeingCameraCount, 2);
    EXPECT_TRUE(estimate.isValid);
    EXPECT_FALSE(estimate.isDegenerate);
    EXPECT_EQ(estimate.particleCount, 200);
    EXPECT_GT(estimate.effectiveSampleSize, 1.0);
    EXPECT_NEAR(estimate.spread(), std::sqrt(estimate.covariance.trace()), 1e-12);
  }
}

TEST(BarreraTracker, SameBitsForAnyNumberOfThreadsAndOnlyForTheSameSeed) {
  const CameraRig rig = barreraRig();
  const FrameSetPtr frames = ballFrames(rig, kBallCenter, 3);
  const auto run = [&](int threads, std::uint64_t seed) {
    ThreadTeam team(threads);
    const auto tracker = startedBarrera(parameters({{"particles", 5000}}), rig, seed);
    tracker->beginFrame(frames);
    SphereEstimate estimate;
    for (int iteration = 0; iteration < 8; ++iteration) {
      estimate = tracker->iterate(team);
    }
    return estimate;
  };
  const SphereEstimate expected = run(1, 7);
  for (const int threads : {2, 4}) {
    const SphereEstimate estimate = run(threads, 7);
    EXPECT_EQ(estimate.mean, expected.mean);
    EXPECT_EQ(estimate.best, expected.best);
    EXPECT_EQ(estimate.covariance, expected.covariance);
    EXPECT_EQ(estimate.effectiveSampleSize, expected.effectiveSampleSize);
  }
  EXPECT_NE(run(1, 8).mean, expected.mean);
}

TEST(BarreraTracker, RestartRepeatsTheRunAndIterationsDiffer) {
  const CameraRig rig = barreraRig();
  const FrameSetPtr frames = ballFrames(rig, kBallCenter);
  ThreadTeam team;
  const auto tracker = startedBarrera(parameters(), rig, 5);
  tracker->beginFrame(frames);
  const Eigen::Vector3d first = tracker->iterate(team).mean;
  const Eigen::Vector3d second = tracker->iterate(team).mean;
  EXPECT_NE(first, second);
  tracker->restart(5);
  EXPECT_EQ(tracker->iterate(team).mean, first);
  EXPECT_EQ(tracker->iterate(team).mean, second);
}

TEST(BarreraTracker, StartIsAPointOrABox) {
  const CameraRig rig = barreraRig();
  Eigen::ArrayXXd positions;
  Eigen::ArrayXd weights;
  startedBarrera(parameters(), rig)->copyParticles(1000, positions, weights);
  ASSERT_EQ(positions.rows(), 200);
  EXPECT_TRUE((positions.col(0) == 0.4).all() && (positions.col(1) == 0.1).all() &&
              (positions.col(2) == 0.2).all());
  EXPECT_NEAR(weights.sum(), 1.0, 1e-12);

  const auto box = parameters({{"particles", 20000}, {"start_half_x", 2.0}, {"start_half_z", 0.5}});
  startedBarrera(box, rig)->copyParticles(20000, positions, weights);
  EXPECT_GE(positions.col(0).minCoeff(), -1.6); // 0.4 - 2
  EXPECT_LE(positions.col(0).maxCoeff(), 2.4);
  EXPECT_TRUE((positions.col(1) == 0.1).all());
  EXPECT_GE(positions.col(2).minCoeff(), -0.3); // 0.2 - 0.5
  EXPECT_LE(positions.col(2).maxCoeff(), 0.7);
  // Uniform of half-size h: standard deviation h / sqrt(3); five standard errors of the mean.
  EXPECT_NEAR(positions.col(0).mean(), 0.4, 5.0 * 2.0 / std::sqrt(3.0 * 20000));
  EXPECT_NEAR((positions.col(0) - 0.4).square().mean(), 4.0 / 3.0, 0.05);
}

// The ball lies 5 cm behind the volume: the cloud gathers at its wall.
TEST(BarreraTracker, StaysInTheVolumeOfInterest) {
  const CameraRig rig = barreraRig();
  const WorldBox volume{{0.45, 0.3, 0.1}, {0.6, 0.45, 0.25}};
  const auto tracker = startedBarrera(
      parameters({{"start_half_x", 1.0}, {"start_half_y", 1.0}, {"particles", 500}}), rig);
  tracker->setVolumeOfInterest(volume);
  Eigen::ArrayXXd positions;
  Eigen::ArrayXd weights;
  tracker->copyParticles(500, positions, weights);
  ASSERT_EQ(positions.rows(), 500);
  for (Eigen::Index k = 0; k < positions.rows(); ++k) {
    EXPECT_TRUE(volume.contains(positions.row(k).transpose().matrix(), 1e-12));
  }
  ThreadTeam team;
  tracker->beginFrame(ballFrames(rig, kBallCenter));
  for (int iteration = 0; iteration < 30; ++iteration) {
    const SphereEstimate estimate = tracker->iterate(team);
    EXPECT_TRUE(volume.contains(estimate.mean, 1e-9)) << iteration;
    EXPECT_TRUE(volume.contains(estimate.best)) << iteration;
  }
  // Where it was is not of interest any more: it begins again where it is.
  const WorldBox beside{{-0.2, 0.3, 0.1}, {0.1, 0.45, 0.25}};
  tracker->setVolumeOfInterest(beside);
  EXPECT_TRUE(beside.contains(tracker->iterate(team).mean, 1e-9));
}

TEST(BarreraTracker, NewParticleCountActsAtTheNextIterationAndKeepsThePlace) {
  const CameraRig rig = barreraRig();
  ThreadTeam team;
  const auto tracker = startedBarrera(parameters({{"start_y", 0.5}, {"start_x", 0.5}}), rig);
  tracker->beginFrame(ballFrames(rig, kBallCenter));
  for (int iteration = 0; iteration < 20; ++iteration) {
    tracker->iterate(team);
  }
  for (const int count : {1000, 50, 3000}) {
    tracker->configure(parameters({{"particles", double(count)}}));
    const SphereEstimate estimate = tracker->iterate(team);
    EXPECT_EQ(estimate.particleCount, count);
    EXPECT_LT((estimate.mean - kBallCenter).norm(), 0.03);
    Eigen::ArrayXXd positions;
    Eigen::ArrayXd weights;
    tracker->copyParticles(1 << 20, positions, weights);
    EXPECT_EQ(positions.rows(), count);
    EXPECT_NEAR(weights.sum(), 1.0, 1e-9);
    tracker->copyParticles(10, positions, weights);
    EXPECT_EQ(positions.rows(), 10);
    EXPECT_LE(weights.sum(), 1.0);
  }
}

TEST(BarreraTracker, ValidNeedsTwoCamerasUnlessThereIsOne) {
  const CameraRig rig = barreraRig();
  ThreadTeam team;
  const auto onBall = parameters(
      {{"start_x", kBallCenter.x()}, {"start_y", kBallCenter.y()}, {"start_z", kBallCenter.z()}});
  const auto tracker = startedBarrera(onBall, rig);
  auto half = std::make_shared<FrameSet>(*ballFrames(rig, kBallCenter));
  half->frames[1] = nullptr;
  tracker->beginFrame(half);
  SphereEstimate estimate = tracker->iterate(team);
  EXPECT_EQ(estimate.seeingCameraCount, 1);
  EXPECT_FALSE(estimate.isValid);

  const CameraRig single(rig.begin(), rig.begin() + 1);
  const auto alone = startedBarrera(onBall, single);
  alone->beginFrame(ballFrames(single, kBallCenter));
  estimate = alone->iterate(team);
  EXPECT_EQ(estimate.seeingCameraCount, 1);
  EXPECT_TRUE(estimate.isValid);
}

TEST(BarreraTracker, WithoutImagesAllParticlesAreEqual) {
  ThreadTeam team;
  const auto tracker = startedBarrera(parameters(), barreraRig());
  tracker->beginFrame(nullptr);
  const SphereEstimate estimate = tracker->iterate(team);
  EXPECT_NEAR(estimate.effectiveSampleSize, 200.0, 1e-9);
  EXPECT_EQ(estimate.seeingCameraCount, 0);
  EXPECT_FALSE(estimate.isValid);
  EXPECT_FALSE(estimate.isDegenerate);
}

TEST(BarreraTracker, AnotherTargetColorIsNotSeen) {
  const CameraRig rig = barreraRig();
  ThreadTeam team;
  const auto tracker = startedBarrera(parameters({{"start_x", kBallCenter.x()},
                                                  {"start_y", kBallCenter.y()},
                                                  {"start_z", kBallCenter.z()}}),
                                      rig);
  tracker->beginFrame(ballFrames(rig, kBallCenter));
  EXPECT_TRUE(tracker->iterate(team).isValid);
  Target blue = redBall();
  blue.color.hueMin = 220.0;
  blue.color.hueMax = 260.0;
  tracker->setTarget(blue);
  EXPECT_EQ(tracker->iterate(team).seeingCameraCount, 0);
}

// The start of the paper lies outside both images, and the ball is in both.
TEST(BarreraTracker, SearchingFromOutsideAnImageDoesNotSayThatTheTargetIsOutside) {
  const CameraRig rig = barreraRig();
  ThreadTeam team;
  const auto tracker = startedBarrera(parameters(), rig);
  tracker->beginFrame(ballFrames(rig, kBallCenter));
  EXPECT_FALSE(tracker->iterate(team).isValid);
  for (const CameraReport& report : tracker->cameraReports()) {
    EXPECT_EQ(report.status, CameraStatus::Elsewhere);
    EXPECT_GT(report.outlineDistancePx, 100.0);
  }
  Target blue = redBall();
  blue.color.hueMin = 220.0;
  blue.color.hueMax = 260.0;
  tracker->setTarget(blue);
  EXPECT_FALSE(tracker->iterate(team).isValid);
  for (const CameraReport& report : tracker->cameraReports()) {
    EXPECT_EQ(report.status, CameraStatus::NoColor);
  }
}

TEST(BarreraTracker, IterationsPerFrameComeFromTheParameters) {
  const auto tracker = startedBarrera(parameters({{"iterations_per_frame", 7}}), barreraRig());
  EXPECT_EQ(tracker->iterationsPerFrame(), 7);
}

} // namespace
} // namespace dewpoint::tests
