// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/dewpoint_tracker.h"
#include "tests/tracking/drawn_run.h"
#include "tests/tracking/sphere_of.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace dewpoint::tests {
namespace {

using drawn::Ball;
using drawn::DrawnRun;
using drawn::kClose;
using drawn::redBall;
using drawn::rigAround;

Eigen::Vector3d onCircle(int frame) {
  const double angle = 2.0 * std::numbers::pi * frame / 60.0; // a turn in 2 s: 0.38 m/s
  return drawn::kMiddle + Eigen::Vector3d(0.12 * std::cos(angle), 0.12 * std::sin(angle),
                                          0.03 * std::sin(2.0 * angle));
}

/// Frames 0 to `count` - 1 of the circle.
void followCircle(DrawnRun& run, int count) {
  for (int frame = 0; frame < count; ++frame) {
    run.show({Ball{onCircle(frame)}});
  }
}

double errorOf(const SphereEstimate& estimate, const Eigen::Vector3d& truth) {
  return (estimate.mean - truth).norm();
}

TEST(DewpointTracker, ConvergesInTwoFramesFromAUniformStart) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    DrawnRun run(rigAround(2), {redBall()}, {}, seed);
    const Eigen::Vector3d truth = drawn::placeNear(seed, 0.2);
    run.show({Ball{truth}});
    const SphereEstimate& estimate = run.show({Ball{truth}});
    EXPECT_LT(errorOf(estimate, truth), kClose) << seed;
    EXPECT_LT((estimate.best - truth).norm(), 0.01) << seed;
    EXPECT_TRUE(estimate.isValid) << seed;
    EXPECT_GT(estimate.existenceProbability, 0.9) << seed;
    EXPECT_EQ(estimate.seeingCameraCount, 2) << seed;
    EXPECT_NEAR(estimate.radius, 0.035, 1e-6) << seed;
    EXPECT_FALSE(estimate.isDegenerate) << seed;
  }
}

TEST(DewpointTracker, StartOutsideTheBoxIsFoundAsWell) {
  DrawnRun run(rigAround(2), {redBall()},
               {{"start_x", 3.0}, {"start_y", 3.0}, {"start_half_x", 0.1}, {"start_half_y", 0.1}});
  for (int frame = 0; frame < 5; ++frame) {
    run.show({Ball{drawn::kMiddle}});
  }
  EXPECT_TRUE(run.estimate().isValid);
  EXPECT_LT(errorOf(run.estimate(), drawn::kMiddle), kClose);
}

// The ball outside is there from the beginning, and looks the same.
TEST(DewpointTracker, SearchesTheVolumeOfInterestAlone) {
  DrawnRun run(rigAround(3), {redBall()});
  const Eigen::Vector3d inside = drawn::kMiddle + Eigen::Vector3d(0.15, 0.0, 0.0);
  const Eigen::Vector3d outside = drawn::kMiddle - Eigen::Vector3d(0.15, 0.0, 0.0);
  const WorldBox volume{drawn::kMiddle - Eigen::Vector3d(0.0, 1.0, 1.0),
                        drawn::kMiddle + Eigen::Vector3d(1.0, 1.0, 1.0)};
  run.tracker().setVolumeOfInterest(volume);
  for (int frame = 0; frame < 6; ++frame) {
    const SphereEstimate estimate = run.show({Ball{outside}});
    EXPECT_FALSE(estimate.isValid) << frame;
    EXPECT_TRUE(volume.contains(estimate.mean, 1e-9)) << frame;
  }
  for (int frame = 0; frame < 10; ++frame) {
    run.show({Ball{outside}, Ball{inside}});
  }
  EXPECT_TRUE(run.estimate().isValid);
  EXPECT_LT(errorOf(run.estimate(), inside), 2.0 * kClose);
}

TEST(DewpointTracker, FollowsMotion) {
  DrawnRun run(rigAround(2), {redBall()});
  double squares = 0.0;
  for (int frame = 0; frame < 90; ++frame) {
    const SphereEstimate& estimate = run.show({Ball{onCircle(frame)}});
    if (frame >= 30) {
      EXPECT_TRUE(estimate.isValid) << frame;
      EXPECT_LT(errorOf(estimate, onCircle(frame)), 2.0 * kClose) << frame;
      squares += errorOf(estimate, onCircle(frame)) * errorOf(estimate, onCircle(frame)) / 60.0;
    }
  }
  EXPECT_LT(std::sqrt(squares), 1.5e-3); // half a pixel
}

TEST(DewpointTracker, RecoversAfterAJump) {
  DrawnRun run(rigAround(2), {redBall()});
  for (std::uint32_t jump = 0; jump < 6; ++jump) {
    // 0.355 m as in the suite, there and back.
    const Eigen::Vector3d half = 0.1775 * drawn::directionOf(jump);
    for (const double side : {-1.0, 1.0}) {
      const Eigen::Vector3d truth = drawn::kMiddle + side * half;
      run.show({Ball{truth}});
      run.show({Ball{truth}});
      EXPECT_TRUE(run.estimate().isValid) << jump;
      EXPECT_LT(errorOf(run.estimate(), truth), 2.0 * kClose) << jump;
      for (int frame = 0; frame < 5; ++frame) {
        run.show({Ball{truth}});
      }
    }
  }
}

TEST(DewpointTracker, LossIsDeclaredWithinThreeFramesAndItsReturnToo) {
  DrawnRun run(rigAround(2), {redBall()});
  followCircle(run, 30);
  ASSERT_TRUE(run.estimate().isValid);
  for (int frame = 0; frame < 3; ++frame) {
    run.show({});
  }
  EXPECT_FALSE(run.estimate().isValid);
  EXPECT_LT(run.estimate().existenceProbability, 0.5);
  for (int frame = 0; frame < 30; ++frame) {
    EXPECT_FALSE(run.show({}).isValid) << frame;
  }
  for (int frame = 0; frame < 3; ++frame) {
    run.show({Ball{onCircle(0)}});
  }
  EXPECT_TRUE(run.estimate().isValid);
  EXPECT_LT(errorOf(run.estimate(), onCircle(0)), kClose);
}

TEST(DewpointTracker, AnEmptySceneHoldsNothing) {
  DrawnRun run(rigAround(3), {redBall()});
  for (int frame = 0; frame < 40; ++frame) {
    const SphereEstimate& estimate = run.show({});
    EXPECT_FALSE(estimate.isValid) << frame;
    EXPECT_LT(estimate.existenceProbability, 0.1) << frame;
    EXPECT_TRUE(isFinite(estimate)) << frame;
  }
}

TEST(DewpointTracker, NothingIsValidBeforeTheFirstFrame) {
  DrawnRun run(rigAround(2), {redBall(), redBall()});
  ASSERT_EQ(run.tracker().trackCount(), 2U);
  EXPECT_FALSE(run.estimate(0).isValid);
  EXPECT_FALSE(run.estimate(1).isValid);
}

// Between frames the estimate moves by what the ball does (nothing) and half a millimeter of
// noise; a camera that fails or returns adds less than a millimeter to it.
TEST(DewpointTracker, ACameraThatFailsOrReturnsMakesNoStep) {
  DrawnRun run(rigAround(3, 2), {redBall()});
  const Eigen::Vector3d truth = drawn::placeNear(3, 0.1);
  for (int frame = 0; frame < 10; ++frame) {
    run.show({Ball{truth}});
  }
  for (const std::size_t failing : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
    for (int frame = 0; frame < 6; ++frame) {
      const Eigen::Vector3d before = run.estimate().mean;
      const std::vector<std::size_t> blind =
          frame < 3 ? std::vector<std::size_t>{failing} : std::vector<std::size_t>{};
      const SphereEstimate& estimate = run.show({Ball{truth}}, blind);
      EXPECT_LT((estimate.mean - before).norm(), 1e-3) << failing << ", frame " << frame;
      EXPECT_TRUE(estimate.isValid);
      EXPECT_EQ(estimate.seeingCameraCount, frame < 3 ? 2 : 3);
    }
  }
}

TEST(DewpointTracker, OneOfTwoCamerasBlackForHalfASecond) {
  DrawnRun run(rigAround(2), {redBall()});
  followCircle(run, 60);
  for (int frame = 60; frame < 75; ++frame) {
    auto frames = drawn::framesOf(run.rig(), {Ball{onCircle(frame)}}, frame);
    auto black = std::make_shared<Frame>(*frames->frames[1]);
    black->image = cv::Mat::zeros(240, 320, CV_8UC3);
    frames->frames[1] = black;
    const SphereEstimate& estimate = run.showSet(frames);
    // The remaining camera knows the direction; along it acceleration and size leave centimeters.
    EXPECT_LT(errorOf(estimate, onCircle(frame)), 0.1) << frame;
  }
  run.show({Ball{onCircle(75)}});
  run.show({Ball{onCircle(76)}});
  EXPECT_TRUE(run.estimate().isValid);
  EXPECT_LT(errorOf(run.estimate(), onCircle(76)), 2.0 * kClose);
}

TEST(DewpointTracker, ADistractorDoesNotCaptureIt) {
  DrawnRun run(rigAround(2), {redBall()});
  for (int frame = 0; frame < 60; ++frame) {
    // The look-alike lies still outside the circle and appears only once the ball is tracked.
    std::vector<Ball> balls{Ball{onCircle(frame)}};
    if (frame >= 10) {
      balls.push_back(Ball{drawn::kMiddle + Eigen::Vector3d(-0.1, 0.22, -0.05)});
    }
    const SphereEstimate& estimate = run.show(balls);
    if (frame >= 5) {
      EXPECT_LT(errorOf(estimate, onCircle(frame)), 3.0 * kClose) << frame;
      EXPECT_TRUE(estimate.isValid) << frame;
    }
  }
}

// Something blue covers half of the disc in camera 0.
TEST(DewpointTracker, HalfHiddenInOneCamera) {
  DrawnRun run(rigAround(2), {redBall()});
  const Eigen::Vector3d truth = drawn::kMiddle;
  for (int frame = 0; frame < 10; ++frame) {
    run.show({Ball{truth}});
  }
  const double column = Projector(run.rig()[0]).project(truth)->x();
  for (int frame = 10; frame < 25; ++frame) {
    auto frames = drawn::framesOf(run.rig(), {Ball{truth}}, frame);
    auto covered = std::make_shared<Frame>(*frames->frames[0]);
    covered->image(cv::Rect(0, 60, static_cast<int>(column), 120)) = cv::Scalar(200, 60, 30);
    frames->frames[0] = covered;
    const SphereEstimate& estimate = run.showSet(frames);
    EXPECT_TRUE(estimate.isValid) << frame;
    EXPECT_LT(errorOf(estimate, truth), 10e-3) << frame;
  }
}

TEST(DewpointTracker, UnknownRadiusIsEstimated) {
  for (const double radius : {0.025, 0.035, 0.05}) {
    DrawnRun run(rigAround(2), {redBall(0.0)});
    for (int frame = 0; frame < 10; ++frame) {
      run.show({Ball{onCircle(frame), radius}});
    }
    EXPECT_TRUE(run.estimate().isValid) << radius;
    EXPECT_NEAR(run.estimate().radius, radius, 0.05 * radius);
    EXPECT_LT(errorOf(run.estimate(), onCircle(9)), 2.0 * kClose) << radius;
  }
}

// The ball is outside the second camera's image: nothing says where along the first one's ray it
// is.
// A quarter too large or too small is measured; a tenth does no harm.
TEST(DewpointTracker, ARadiusThatIsGivenWronglyIsCorrected) {
  for (const double factor : {0.75, 0.9, 1.1, 1.25}) {
    Target target = redBall();
    target.radius *= factor;
    DrawnRun run(rigAround(2), {target});
    for (int frame = 0; frame < 10; ++frame) {
      run.show({Ball{onCircle(frame)}});
    }
    EXPECT_TRUE(run.estimate().isValid) << factor;
    EXPECT_NEAR(run.estimate().radius, 0.035, 0.11 * 0.035) << factor;
    EXPECT_LT(errorOf(run.estimate(), onCircle(9)), 2.0 * kClose) << factor;
  }
}

TEST(DewpointTracker, NothingIsBornInOneCamerasViewOfTwo) {
  const Eigen::Vector3d aside = drawn::kMiddle + Eigen::Vector3d(0.0, 0.7, 0.0);
  const CameraRig both = rigAround(2);
  DrawnRun one({both[0]}, {redBall()});
  DrawnRun two(both, {redBall()});
  for (int frame = 0; frame < 15; ++frame) {
    one.show({Ball{aside}});
    two.show({Ball{aside}});
    EXPECT_FALSE(two.estimate().isValid) << frame;
    EXPECT_LT(two.estimate().existenceProbability, 0.5) << frame;
  }
  EXPECT_TRUE(
      one.estimate().isValid); // a camera that is alone is believed: its image shows the ball
}

TEST(DewpointTracker, StatesTheCalibrationError) {
  DrawnRun exact(rigAround(2), {redBall()}, {{"calibration_error", 0.0}, {"time_error", 0.0}});
  DrawnRun wrong(rigAround(2), {redBall()}, {{"calibration_error", 1.0}, {"time_error", 0.0}});
  for (int frame = 0; frame < 3; ++frame) {
    exact.show({Ball{drawn::kMiddle}});
    wrong.show({Ball{drawn::kMiddle}});
  }
  EXPECT_EQ(exact.estimate().mean, wrong.estimate().mean);
  const Eigen::Matrix3d added = wrong.estimate().covariance - exact.estimate().covariance;
  // A degree at the cameras' mean distance, across one ray; two such rays at a right angle nearly.
  const double distance = 0.5 * ((exact.rig()[0].center() - drawn::kMiddle).norm() +
                                 (exact.rig()[1].center() - drawn::kMiddle).norm());
  const double variance = std::pow(distance * std::numbers::pi / 180.0, 2);
  const Eigen::Vector3d along = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(added).eigenvalues();
  EXPECT_GT(along.minCoeff(), 0.45 * variance);
  EXPECT_LT(along.minCoeff(), 0.55 * variance);
  EXPECT_LT(along.maxCoeff(), 1.5 * variance);
}

TEST(DewpointTracker, StatesTheTimeErrorOfAMovingTarget) {
  DrawnRun exact(rigAround(2), {redBall()}, {{"calibration_error", 0.0}, {"time_error", 0.0}});
  DrawnRun late(rigAround(2), {redBall()}, {{"calibration_error", 0.0}, {"time_error", 20.0}});
  followCircle(exact, 40);
  followCircle(late, 40);
  EXPECT_EQ(exact.estimate().mean, late.estimate().mean);
  const double speed = 30.0 * (onCircle(39) - onCircle(38)).norm();
  const double added = (late.estimate().covariance - exact.estimate().covariance).trace();
  EXPECT_NEAR(std::sqrt(added), 0.02 * speed, 0.2 * 0.02 * speed);
}

/// A target half of whose pixels are darker than its range, by the noise of the images: its color
/// reaches farther than it was learned.
Target halfTooDark() {
  Target target = redBall();
  target.color.intensityMin = 230.0 / (3.0 * 255.0);
  return target;
}

TEST(DewpointTracker, HowFarAColorReachesStaysWhenAParameterChanges) {
  DrawnRun run(rigAround(2), {halfTooDark()});
  for (int frame = 0; frame < 3; ++frame) {
    run.show({Ball{drawn::kMiddle}});
  }
  ASSERT_TRUE(run.estimate().isValid);
  const std::vector<ColorRanges> reached = run.estimate().colors;
  ASSERT_FALSE(reached.empty());
  run.tracker().configure(drawn::parametersOf("dewpoint", {{"particles", 2000}}));
  EXPECT_EQ(run.show({Ball{drawn::kMiddle}}).colors, reached);
}

TEST(DewpointTracker, ARestartLooksAtOnceHowFarAColorReaches) {
  DrawnRun run(rigAround(2), {halfTooDark()});
  for (int frame = 0; frame < 13; ++frame) {
    run.show({}); // nothing to be seen: the next look comes later
  }
  run.tracker().restart(1);
  EXPECT_FALSE(run.show({Ball{drawn::kMiddle}}).colors.empty());
}

TEST(DewpointTracker, ParticlesAreThoseOfTheStartBoxAtFirst) {
  DrawnRun run(rigAround(2), {redBall()}, {{"particles", 2000}});
  Eigen::ArrayXXd positions;
  Eigen::ArrayXd weights;
  run.tracker().copyParticles(0, 100000, positions, weights);
  ASSERT_EQ(positions.rows(), 2000);
  EXPECT_NEAR(weights.sum(), 1.0, 1e-9);
  // The default box: 0 to 1, 0 to 1, 0 to 0.5.
  EXPECT_GE(positions.minCoeff(), 0.0);
  EXPECT_LE(positions.leftCols(2).maxCoeff(), 1.0);
  EXPECT_LE(positions.col(2).maxCoeff(), 0.5);
  EXPECT_LT(positions.col(0).minCoeff(), 0.05);
  EXPECT_GT(positions.col(0).maxCoeff(), 0.95);
  // A new start acts at once while nothing was seen.
  run.tracker().configure(drawn::parametersOf("dewpoint", {{"start_x", 4.0}, {"particles", 2000}}));
  run.tracker().copyParticles(0, 100000, positions, weights);
  EXPECT_GE(positions.col(0).minCoeff(), 3.5);
}

TEST(DewpointTracker, ParticlesGatherAroundTheTarget) {
  DrawnRun run(rigAround(2), {redBall()});
  followCircle(run, 10);
  Eigen::ArrayXXd positions;
  Eigen::ArrayXd weights;
  run.tracker().copyParticles(0, 100000, positions, weights);
  ASSERT_EQ(positions.rows(), run.estimate().particleCount);
  EXPECT_NEAR(weights.sum(), 1.0, 1e-9);
  const Eigen::Vector3d mean = (positions.colwise() * weights).colwise().sum().transpose();
  EXPECT_LT((mean - run.estimate().mean).norm(), 1e-9);
  run.tracker().copyParticles(0, 10, positions, weights);
  EXPECT_EQ(positions.rows(), 10);
  EXPECT_LE(weights.sum(), 1.0 + 1e-9);
}

TEST(DewpointTracker, NewColorsActAtTheNextIteration) {
  DrawnRun run(rigAround(2), {redBall()});
  followCircle(run, 10);
  ASSERT_TRUE(run.estimate().isValid);
  Target blue = redBall();
  blue.color.hueMin = 220.0;
  blue.color.hueMax = 260.0;
  run.tracker().setTargets({blue});
  for (int frame = 10; frame < 14; ++frame) {
    run.show({Ball{onCircle(frame)}});
  }
  EXPECT_EQ(run.estimate().seeingCameraCount, 0);
  EXPECT_FALSE(run.estimate().isValid);
}

} // namespace
} // namespace dewpoint::tests
