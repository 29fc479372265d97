// SPDX-License-Identifier: GPL-3.0-or-later
// Method `dewpoint` where things are not as they should be, and what it promises of its numbers.
#include "tests/tracking/drawn_run.h"
#include "tests/tracking/sphere_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace dewpoint::tests {
namespace {

using drawn::Ball;
using drawn::DrawnRun;
using drawn::redBall;
using drawn::rigAround;

Eigen::Vector3d moving(int frame) {
  return drawn::kMiddle + Eigen::Vector3d(-0.15 + 0.006 * frame, 0.05, 0.02);
}

/// Every kind of frame set without use: each in the midst of good ones.
const std::vector<std::function<FrameSetPtr(std::shared_ptr<FrameSet>)>>& spoiledFrames() {
  static const std::vector<std::function<FrameSetPtr(std::shared_ptr<FrameSet>)>> kinds{
      [](auto) { return nullptr; },
      [](auto set) {
        set->frames.clear();
        return set;
      },
      [](auto set) {
        set->frames.resize(1);
        return set;
      },
      [](auto set) {
        set->frames.assign(2, nullptr);
        return set;
      },
      [](auto set) {
        set->frames.assign(2, std::make_shared<Frame>()); // an image without pixels
        return set;
      },
      [](auto set) {
        auto black = std::make_shared<Frame>(*set->frames[0]);
        black->image = cv::Mat::zeros(240, 320, CV_8UC3);
        set->frames.assign(2, black);
        return set;
      },
      [](auto set) {
        auto small = std::make_shared<Frame>(*set->frames[0]);
        small->image = cv::Mat(17, 23, CV_8UC3, cv::Scalar(1, 2, 3));
        set->frames.assign(2, small);
        return set;
      },
  };
  return kinds;
}

TEST(DewpointRobustness, SurvivesFramesOfNoUse) {
  for (std::size_t kind = 0; kind < spoiledFrames().size(); ++kind) {
    DrawnRun run(rigAround(2), {redBall()});
    for (int frame = 0; frame < 30; ++frame) {
      auto set = drawn::framesOf(run.rig(), {Ball{moving(frame)}}, frame);
      const bool spoiled = frame < 2 || (frame >= 12 && frame < 16);
      EXPECT_TRUE(isFinite(run.showSet(spoiled ? spoiledFrames()[kind](set) : set)))
          << "kind " << kind << ", frame " << frame;
    }
    EXPECT_TRUE(run.estimate().isValid) << kind;
    EXPECT_LT((run.estimate().mean - moving(29)).norm(), 5e-3) << kind;
  }
}

TEST(DewpointRobustness, FollowsTheTargetThroughFadingLight) {
  DrawnRun run(rigAround(2), {redBall()});
  for (int frame = 0; frame < 90; ++frame) {
    // Full light until the background is known, then down to 0.15 within 60 frames.
    const double gain = std::pow(0.15, std::max(0, frame - 30) / 59.0);
    const Eigen::Vector3d place =
        drawn::kMiddle + Eigen::Vector3d(-0.15 + 0.003 * frame, 0.05, 0.02);
    auto set = drawn::framesOf(run.rig(), {Ball{place}}, frame, {}, 0.0);
    for (std::size_t camera = 0; camera < set->frames.size(); ++camera) {
      auto dimmed = std::make_shared<Frame>(*set->frames[camera]);
      cv::multiply(set->frames[camera]->image, cv::Scalar::all(gain), dimmed->image);
      drawn::addNoise(dimmed->image, 2.0, static_cast<std::uint32_t>(frame), 99 + camera);
      set->frames[camera] = dimmed;
    }
    const SphereEstimate& estimate = run.showSet(set);
    EXPECT_TRUE(estimate.isValid) << frame;
    EXPECT_LT((estimate.mean - place).norm(), 3e-3) << frame; // a twelfth of the radius
  }
}

// All cameras black for a second: declared while it can be right, withdrawn before it is far off,
// and there at once when sight returns.
TEST(DewpointRobustness, WithoutSightATargetIsDeclaredWhileItCanBeRight) {
  DrawnRun run(rigAround(2), {redBall()});
  double existenceProbability = 1.0;
  for (int frame = 0; frame < 100; ++frame) {
    const double angle = 2.0 * frame / 30.0; // 0.2 m/s and 0.4 m/s² on a circle of 0.1 m
    const Eigen::Vector3d place =
        drawn::kMiddle + 0.1 * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
    auto set = drawn::framesOf(run.rig(), {Ball{place}}, frame);
    const bool black = frame >= 60 && frame < 90;
    for (std::size_t camera = 0; black && camera < set->frames.size(); ++camera) {
      auto covered = std::make_shared<Frame>(*set->frames[camera]);
      covered->image = cv::Mat::zeros(covered->image.size(), CV_8UC3);
      set->frames[camera] = covered;
    }
    const SphereEstimate& estimate = run.showSet(set);
    const double error = (estimate.mean - place).norm();
    if (!black) {
      EXPECT_TRUE(estimate.isValid) << frame;
      EXPECT_LT(error, 2e-3) << frame;
      continue;
    }
    EXPECT_LE(estimate.existenceProbability, frame == 60 ? 1.0 : existenceProbability) << frame;
    existenceProbability = estimate.existenceProbability;
    EXPECT_TRUE(frame > 63 || estimate.isValid) << frame; // a tenth of a second is bridged
    EXPECT_TRUE(!estimate.isValid || error < 0.05) << frame << ": " << error;
  }
  EXPECT_LT(existenceProbability, 0.2);
}

TEST(DewpointRobustness, NothingButFramesOfNoUse) {
  for (std::size_t kind = 0; kind < spoiledFrames().size(); ++kind) {
    DrawnRun run(rigAround(2), {redBall(), redBall(0.0)});
    for (int frame = 0; frame < 20; ++frame) {
      run.showSet(spoiledFrames()[kind](drawn::framesOf(run.rig(), {}, frame)));
      EXPECT_TRUE(isFinite(run.estimate(0))) << kind;
      EXPECT_TRUE(isFinite(run.estimate(1))) << kind;
    }
    EXPECT_FALSE(run.estimate(0).isValid) << kind;
    EXPECT_FALSE(run.estimate(1).isValid) << kind;
  }
}

FrameSetPtr allRed(const CameraRig& rig, int index) {
  auto set = drawn::framesOf(rig, {}, index);
  for (FramePtr& frame : set->frames) {
    auto red = std::make_shared<Frame>(*frame);
    red->image.setTo(cv::Scalar(0, 0, 230));
    frame = red;
  }
  return set;
}

// As when a hand covers the lens.
TEST(DewpointRobustness, SurvivesImagesOfNothingButTheColor) {
  DrawnRun run(rigAround(2), {redBall()});
  for (int frame = 0; frame < 30; ++frame) {
    const bool covered = frame >= 12 && frame < 16;
    EXPECT_TRUE(
        isFinite(run.showSet(covered ? allRed(run.rig(), frame)
                                     : drawn::framesOf(run.rig(), {Ball{moving(frame)}}, frame))));
  }
  EXPECT_TRUE(run.estimate().isValid);
  EXPECT_LT((run.estimate().mean - moving(29)).norm(), 5e-3);
}

TEST(DewpointRobustness, AnImageOfNothingButTheColorHoldsNothing) {
  DrawnRun run(rigAround(2), {redBall(), redBall(0.0)});
  for (int frame = 0; frame < 10; ++frame) {
    run.showSet(allRed(run.rig(), frame));
    EXPECT_FALSE(run.estimate(0).isValid) << frame;
    EXPECT_FALSE(run.estimate(1).isValid) << frame;
  }
}

TEST(DewpointRobustness, NoTargetsAndNoCameras) {
  DrawnRun none(rigAround(2), {});
  none.tracker().beginFrame(drawn::framesOf(none.rig(), {}, 0));
  ThreadTeam team;
  none.tracker().iterate(team);
  EXPECT_EQ(none.tracker().trackCount(), 0U);
  DrawnRun blind(CameraRig{}, {redBall()});
  for (int frame = 0; frame < 5; ++frame) {
    EXPECT_FALSE(blind.show({}).isValid);
    EXPECT_TRUE(isFinite(blind.estimate()));
  }
}

/// Everything a run of two targets says, over 20 frames with a disappearance.
std::vector<double> bitsOf(int threads, std::uint64_t seed) {
  DrawnRun run(rigAround(2), {redBall(), redBall(0.0)}, {{"particles", 3000}, {"kld_error", 0.0}},
               seed, threads);
  std::vector<double> all;
  for (int frame = 0; frame < 20; ++frame) {
    std::vector<Ball> balls{Ball{moving(frame)}};
    if (frame < 8 || frame > 12) {
      balls.push_back(Ball{drawn::kMiddle + Eigen::Vector3d(0.0, -0.15, 0.0), 0.03});
    }
    run.show(balls);
    for (std::size_t target = 0; target < 2; ++target) {
      const SphereEstimate& e = run.estimate(target);
      all.insert(all.end(), e.mean.data(), e.mean.data() + 3);
      all.insert(all.end(), e.best.data(), e.best.data() + 3);
      all.insert(all.end(), e.covariance.data(), e.covariance.data() + 9);
      all.insert(all.end(),
                 {e.existenceProbability, e.effectiveSampleSize, e.radius, double(e.particleCount),
                  double(e.seeingCameraCount), double(e.isValid)});
    }
  }
  return all;
}

TEST(DewpointRobustness, SameBitsForAnyNumberOfThreadsAndOnlyForTheSameSeed) {
  const std::vector<double> expected = bitsOf(1, 7);
  EXPECT_EQ(bitsOf(2, 7), expected);
  EXPECT_EQ(bitsOf(4, 7), expected);
  EXPECT_NE(bitsOf(1, 8), expected);
}

TEST(DewpointRobustness, RestartRepeatsTheRun) {
  DrawnRun run(rigAround(2), {redBall()}, {}, 5);
  const auto pass = [&] {
    std::vector<Eigen::Vector3d> means;
    for (int frame = 0; frame < 10; ++frame) {
      means.push_back(run.showSet(drawn::framesOf(run.rig(), {Ball{moving(frame)}}, frame)).mean);
    }
    return means;
  };
  const auto first = pass();
  run.tracker().restart(5);
  EXPECT_FALSE(run.estimate().isValid);
  EXPECT_EQ(pass(), first);
  run.tracker().restart(6);
  EXPECT_NE(pass(), first);
}

// A budget that no machine keeps (0.5 ns per iteration would be needed): the count of particles
// falls to its floor of ten; without a budget it stays.
TEST(DewpointRobustness, ATimeBudgetReducesTheParticles) {
  DrawnRun run(rigAround(2), {redBall()}, {{"kld_error", 0.0}, {"particles", 4000}});
  for (int frame = 0; frame < 8; ++frame) {
    run.show({Ball{moving(frame)}});
  }
  EXPECT_EQ(run.estimate().particleCount, 4000);
  run.tracker().configure(drawn::parametersOf(
      "dewpoint", {{"kld_error", 0.0}, {"particles", 4000}, {"time_budget", 1e-6}}));
  for (int frame = 8; frame < 20; ++frame) {
    run.show({Ball{moving(frame)}});
  }
  EXPECT_LE(run.estimate().particleCount, 100);
  EXPECT_GE(run.estimate().particleCount, 10);
  EXPECT_TRUE(run.estimate().isValid);
  EXPECT_LT((run.estimate().mean - moving(19)).norm(), 10e-3);
  run.tracker().configure(
      drawn::parametersOf("dewpoint", {{"kld_error", 0.0}, {"particles", 4000}}));
  run.show({Ball{moving(20)}});
  run.show({Ball{moving(21)}});
  EXPECT_EQ(run.estimate().particleCount, 4000);
}

// The samples of the evidence lie at 0.8 and 1.25 radii: both balls show all of it. The smaller one
// lies where the search starts.
TEST(DewpointRobustness, AThingALittleSmallerIsNotTakenForTheBall) {
  const Eigen::Vector3d ball = drawn::kMiddle + Eigen::Vector3d(0.12, 0.05, 0.0);
  const Ball smaller{drawn::kMiddle, 0.85 * 0.035};
  DrawnRun run(rigAround(2), {redBall()},
               {{"start_x", drawn::kMiddle.x()},
                {"start_y", drawn::kMiddle.y()},
                {"start_z", drawn::kMiddle.z()}});
  for (int frame = 0; frame < 5; ++frame) {
    run.show({Ball{ball}, smaller});
  }
  EXPECT_TRUE(run.estimate().isValid);
  EXPECT_LT((run.estimate().mean - ball).norm(), 5e-3);
}

// The same budget as before: what it leaves of a search is a piece per frame, eleven in all for two
// cameras (SlicedSearch), and what that finds is at most eleven frames old when the search begins
// anew.
TEST(DewpointRobustness, ATargetIsFoundWithoutTimeAsWell) {
  DrawnRun run(rigAround(2), {redBall()}, {{"time_budget", 1e-6}});
  for (int frame = 0; frame < 12; ++frame) {
    run.show({Ball{drawn::kMiddle}});
  }
  EXPECT_TRUE(run.estimate().isValid);
  const Eigen::Vector3d elsewhere = drawn::kMiddle + Eigen::Vector3d(0.2, 0.1, 0.0);
  for (int frame = 0; frame < 24; ++frame) {
    run.show({Ball{elsewhere}});
  }
  EXPECT_TRUE(run.estimate().isValid);
  EXPECT_LT((run.estimate().mean - elsewhere).norm(), 10e-3);
}

// A budget of a second is never reached; searches take the other way nevertheless, and keep a ball
// apart from a look-alike that it passes.
TEST(DewpointRobustness, DistractorsAreFoundWithinABudget) {
  const auto passing = [](int frame) { // 45 cm in 90 frames, through the place of the other
    return Eigen::Vector3d(drawn::kMiddle + Eigen::Vector3d(-0.2 + 0.005 * frame, 0.0, 0.0));
  };
  const Eigen::Vector3d other = drawn::kMiddle + Eigen::Vector3d(0.05, 0.12, 0.0);
  DrawnRun run(rigAround(2), {redBall()},
               {{"time_budget", 1000.0},
                {"start_half_x", 0.05},
                {"start_half_y", 0.05},
                {"start_half_z", 0.05},
                {"start_x", passing(0).x()},
                {"start_y", passing(0).y()},
                {"start_z", passing(0).z()}});
  for (int frame = 0; frame < 80; ++frame) {
    run.show({Ball{passing(frame)}, Ball{other}});
  }
  EXPECT_TRUE(run.estimate().isValid);
  EXPECT_LT((run.estimate().mean - passing(79)).norm(), 10e-3);
}

/// How many particles a ball that is well seen gets.
int particlesWhenSure(drawn::Changes changes) {
  DrawnRun run(rigAround(2), {redBall()}, changes);
  for (int frame = 0; frame < 10; ++frame) {
    run.show({Ball{moving(frame)}});
  }
  EXPECT_TRUE(run.estimate().isValid);
  EXPECT_LT((run.estimate().mean - moving(9)).norm(), 5e-3);
  return run.estimate().particleCount;
}

TEST(DewpointRobustness, ParticlesAdaptBetweenFewestAndMost) {
  const auto count = [](double error) {
    return particlesWhenSure({{"particles", 2000}, {"fewest_particles", 50}, {"kld_error", error}});
  };
  EXPECT_EQ(count(0.0), 2000); // always the most
  int last = 2000;
  for (const double error : {0.01, 0.3, 1.0}) {
    const int here = count(error);
    EXPECT_LE(here, last) << error;
    EXPECT_GE(here, 50) << error;
    last = here;
  }
  EXPECT_LT(last, 500);
  // The fewest are never more than the most.
  EXPECT_EQ(particlesWhenSure({{"particles", 60}, {"fewest_particles", 800}}), 60);
}

TEST(DewpointRobustness, DefaultsUseFewerParticlesWhenSure) {
  EXPECT_LT(particlesWhenSure({}), 400); // of 500
}

// A further iteration on the same frame does not count the same evidence twice: place, covariance
// and existence stay, but for the sampling noise of other random numbers.
TEST(DewpointRobustness, RepeatedIterationsDoNotShrinkTheCovariance) {
  DrawnRun run(rigAround(2), {redBall()}, {{"particles", 1000}, {"kld_error", 0.0}});
  for (int frame = 0; frame < 10; ++frame) {
    run.show({Ball{moving(frame)}});
  }
  const SphereEstimate once = run.estimate();
  for (int iteration = 0; iteration < 30; ++iteration) {
    const SphereEstimate& again = run.again();
    EXPECT_NEAR(again.covariance.trace(), once.covariance.trace(), 0.05 * once.covariance.trace());
    EXPECT_LT((again.mean - once.mean).norm(), 1e-3);
    EXPECT_NEAR(again.existenceProbability, once.existenceProbability, 0.01);
  }
}

TEST(DewpointRobustness, AFewParticlesMoreIterationsAreAskedFor) {
  DrawnRun run(rigAround(2), {redBall()}, {{"iterations_per_frame", 7}, {"particles", 10}});
  EXPECT_EQ(run.tracker().iterationsPerFrame(), 7);
  for (int frame = 0; frame < 5; ++frame) {
    run.show({Ball{moving(frame)}});
  }
  EXPECT_EQ(run.estimate().particleCount, 10);
  EXPECT_LT((run.estimate().mean - moving(4)).norm(), 10e-3);
}

TEST(DewpointRobustness, SeekingBackwardsAndFarForwards) {
  DrawnRun run(rigAround(2), {redBall()});
  for (int frame = 0; frame < 40; ++frame) {
    run.show({Ball{moving(frame)}});
  }
  for (const int seek : {3, 30, 1000, 5, 0}) {
    for (int frame = seek; frame < seek + 3; ++frame) {
      const Eigen::Vector3d truth = moving(frame % 45);
      run.showSet(drawn::framesOf(run.rig(), {Ball{truth}}, frame));
      EXPECT_TRUE(isFinite(run.estimate()));
    }
    EXPECT_TRUE(run.estimate().isValid) << seek;
    EXPECT_LT((run.estimate().mean - moving((seek + 2) % 45)).norm(), 6e-3) << seek;
  }
}

TEST(DewpointRobustness, TheSameFrameTimeAgain) {
  DrawnRun run(rigAround(2), {redBall()});
  for (int frame = 0; frame < 10; ++frame) {
    run.showSet(drawn::framesOf(run.rig(), {Ball{moving(0)}}, 4));
  }
  EXPECT_TRUE(run.estimate().isValid);
  EXPECT_LT((run.estimate().mean - moving(0)).norm(), 3e-3);
}

} // namespace
} // namespace dewpoint::tests
