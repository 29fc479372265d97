// SPDX-License-Identifier: GPL-3.0-or-later
// A copy of a tracker goes on with the same bits, whatever happens to the one it was copied from.
#include "tests/tracking/drawn_run.h"

#include <gtest/gtest.h>

#include <string>

namespace dewpoint::tests {
namespace {

using drawn::Ball;

struct Case {
  std::string method;
  bool lookAlike = false;
};

/// A ball on a circle, and a red thing at rest that may be taken for it; hidden for a while.
std::vector<Ball> ballsAt(int frame, bool lookAlike) {
  const double angle = 0.05 * frame;
  std::vector<Ball> balls;
  if (frame < 40 || frame > 46) {
    balls.push_back(
        {drawn::kMiddle + Eigen::Vector3d(0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.0)});
  }
  if (lookAlike) {
    balls.push_back({drawn::kMiddle + Eigen::Vector3d(-0.22, -0.05, 0.02)});
  }
  return balls;
}

class Clone : public ::testing::TestWithParam<Case> {
protected:
  Clone() : rig_(drawn::rigAround(2)) {}

  std::unique_ptr<Tracker> fresh() {
    auto tracker = makeTracker(
        GetParam().method,
        drawn::parametersOf(GetParam().method.c_str(), {{"start_x", 0.6}, {"start_y", 0.5}}), rig_,
        {drawn::redBall()});
    EXPECT_TRUE(tracker);
    (*tracker)->restart(3);
    return std::move(*tracker);
  }
  void track(Tracker& tracker, int frame) {
    tracker.beginFrame(drawn::framesOf(rig_, ballsAt(frame, GetParam().lookAlike), frame));
    tracker.iterate(team_);
  }
  static void expectSameBits(const Tracker& a, const Tracker& b, int frame) {
    ASSERT_EQ(sphereOf(a).mean, sphereOf(b).mean) << frame;
    ASSERT_EQ(sphereOf(a).covariance, sphereOf(b).covariance) << frame;
    ASSERT_EQ(sphereOf(a).existenceProbability, sphereOf(b).existenceProbability) << frame;
    Eigen::ArrayXXd positions[2];
    Eigen::ArrayXd weights[2];
    capability<ParticleCloud>(a)->copyParticles(0, 1000, positions[0], weights[0]);
    capability<ParticleCloud>(b)->copyParticles(0, 1000, positions[1], weights[1]);
    ASSERT_TRUE((positions[0] == positions[1]).all()) << frame;
    ASSERT_TRUE((weights[0] == weights[1]).all()) << frame;
  }

  CameraRig rig_;
  ThreadTeam team_;
};

TEST_P(Clone, GoesOnWithTheSameBits) {
  const auto straight = fresh();
  const auto copied = fresh();                  // being copied changes nothing
  std::vector<std::unique_ptr<Tracker>> copies; // right before frames 10, 20, ... 60
  for (int frame = 0; frame < 70; ++frame) {
    if (frame % 10 == 0 && frame > 0) {
      copies.push_back(capability<Copyable>(*copied)->clone());
      ASSERT_NE(copies.back(), nullptr);
      copies.back()->beginFrame(nullptr); // lets go of the images
    }
    track(*straight, frame);
    track(*copied, frame);
    expectSameBits(*straight, *copied, frame);
  }
  // Every copy goes on by itself, the first through the frames in which the others were made.
  for (std::size_t k = 0; k < copies.size(); ++k) {
    const auto straightAgain = fresh();
    const int begin = 10 * (static_cast<int>(k) + 1);
    for (int frame = 0; frame < begin + 8; ++frame) {
      track(*straightAgain, frame);
      if (frame >= begin) {
        track(*copies[k], frame);
        expectSameBits(*straightAgain, *copies[k], frame);
      }
    }
  }
  const auto again = capability<Copyable>(*copied)->clone();
  expectSameBits(*straight, *again, 70);
  EXPECT_GT(capability<Copyable>(*again)->memoryBytes(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Methods, Clone,
                         testing::Values(Case{"barrera"}, Case{"dewpoint"}, Case{"dewpoint", true},
                                         Case{"dynamics"}),
                         [](const auto& test) {
                           return test.param.method + (test.param.lookAlike ? "Twin" : "");
                         });

} // namespace
} // namespace dewpoint::tests
