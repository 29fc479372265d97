// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/calibration/bundle/bundle_adjustment.h"
#include "core/calibration/bundle/bundle_cost.h"
#include "core/geometry/sphere_image.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

Camera cameraFrom(const std::string& name, const Eigen::Vector3d& position) {
  Camera camera;
  camera.name = name;
  camera.intrinsics = {640, 480, 500.0, 510.0, 320.0, 240.0};
  camera.cameraFromWorld = lookAt(position, {0.0, 0.0, 0.5});
  return camera;
}

CameraRig fourCameras() {
  return {cameraFrom("a", {2.0, 2.0, 1.5}), cameraFrom("b", {-2.0, 2.0, 1.2}),
          cameraFrom("c", {-2.0, -2.0, 1.8}), cameraFrom("d", {2.0, -2.0, 1.0})};
}

Eigen::Vector3d wavedBall(double t) {
  return {0.4 * std::sin(4.1 * t), 0.4 * std::sin(5.3 * t + 1.0), 0.5 + 0.3 * std::sin(3.1 * t)};
}

/// The same rig, each camera moved by 4 cm and turned by 1 degree, differently.
std::vector<BundleCamera> nudged(const CameraRig& rig) {
  std::vector<BundleCamera> cameras;
  for (std::size_t c = 0; c < rig.size(); ++c) {
    const auto draw = RandomStream(7, 0, 0, RandomPurpose::Noise).normal4(std::uint32_t(c));
    const Eigen::Vector3d way = Eigen::Vector3d(draw[0], draw[1], draw[2]).normalized();
    BundleCamera camera;
    camera.camera = rig[c];
    camera.camera.cameraFromWorld.linear() =
        rotationExponential(0.0175 * way) * rig[c].cameraFromWorld.linear();
    camera.camera.cameraFromWorld.translation() += 0.04 * way.reverse();
    cameras.push_back(camera);
  }
  return cameras;
}

/// A ball or stick waved for `count` frames at 30 per second before the rig.
BundleProblem wavedProblem(const CameraRig& rig, bool stick, int count, double noise = 0.0,
                           const std::vector<double>& offsets = {0.0, 0.0, 0.0, 0.0}) {
  BundleProblem problem;
  problem.cameras = nudged(rig);
  problem.bodies.push_back(
      {"wand", stick ? BundleBody::Kind::Stick : BundleBody::Kind::Point, 0.5});
  const RandomStream random(3, 0, 0, RandomPurpose::Noise);
  for (int f = 0; f < count; ++f) {
    BundleState state;
    state.time = f / 30.0;
    for (std::size_t c = 0; c < rig.size(); ++c) {
      const double t = state.time + offsets[c];
      for (std::size_t p = 0; p < (stick ? 2U : 1U); ++p) {
        const Eigen::Vector3d end =
            0.5 * double(p) * Eigen::Vector3d(std::cos(2.0 * t), std::sin(2.0 * t), 0.0);
        const auto draw = random.normal4(std::uint32_t(problem.observations.size()));
        const auto pixel = Projector(rig[c]).project(wavedBall(t) + end);
        problem.observations.push_back(
            {c, problem.states.size(), p, *pixel + noise * Eigen::Vector2d(draw[0], draw[1])});
      }
    }
    problem.states.push_back(state);
  }
  return problem;
}

double distance(const Camera& one, const Camera& other) {
  return (one.center() - other.center()).norm();
}

TEST(BundleAdjustment, DerivativesAreThoseOfFiniteDifferences) {
  for (const LensModel lens : {LensModel::Pinhole, LensModel::Fisheye}) {
    PixelCostSetup setup;
    setup.lens = lens;
    setup.outlineShift = 0.01;
    setup.knotTimes = {0.0, 0.1, 0.2};
    setup.imageTime = 0.12;
    setup.sigma = 0.5;
    const PixelCost cost(setup);
    std::vector<std::vector<double>> values{
        {0.1, -0.2, 0.3, 0.1, 0.2, -2.0},
        {500.0, 1.02, 320.0, 240.0, 0.1, -0.05, 0.001, -0.002, 0.02, 0.01, -0.01, 0.003},
        {0.01},
        {0.3, 0.1, 0.2},
        {0.4, 0.2, 0.1},
        {0.5, 0.1, 0.3}};
    std::vector<double*> blocks;
    std::vector<std::vector<double>> slopes;
    std::vector<double*> jacobians;
    for (auto& block : values) {
      blocks.push_back(block.data());
      slopes.emplace_back(2 * block.size());
    }
    for (auto& slope : slopes) {
      jacobians.push_back(slope.data());
    }
    std::array<double, 2> here{};
    ASSERT_TRUE(cost.Evaluate(blocks.data(), here.data(), jacobians.data()));
    for (std::size_t b = 0; b < values.size(); ++b) {
      for (std::size_t i = 0; i < values[b].size(); ++i) {
        const double kept = values[b][i];
        std::array<double, 2> above{}, below{};
        const double step = 1e-5;
        values[b][i] = kept + step;
        cost.Evaluate(blocks.data(), above.data(), nullptr);
        values[b][i] = kept - step;
        cost.Evaluate(blocks.data(), below.data(), nullptr);
        values[b][i] = kept;
        for (std::size_t row = 0; row < 2; ++row) {
          const double expected = (above[row] - below[row]) / (2.0 * step);
          EXPECT_NEAR(slopes[b][row * values[b].size() + i], expected,
                      1e-5 * std::max(1.0, std::abs(expected)))
              << "block " << b << " entry " << i;
        }
      }
    }
  }
}

TEST(BundleAdjustment, AStickBringsTheRigBackToTheBit) {
  const CameraRig rig = fourCameras();
  BundleProblem problem = wavedProblem(rig, true, 40);
  problem.cameras[0].camera = rig[0];
  problem.cameras[0].isPoseFixed = true;
  const auto result = adjustBundle(problem);
  ASSERT_TRUE(result) << errorSentence(result.error());
  EXPECT_LT(result->rmsPx, 1e-6);
  for (std::size_t c = 0; c < rig.size(); ++c) {
    EXPECT_LT(distance(result->cameras[c], rig[c]), 1e-7);
  }
  EXPECT_EQ(result->covariance.gaugeFreedomCount, 0);
  EXPECT_EQ(result->covariance.columns.size(), 18U); // three free poses
  const auto again = adjustBundle(problem);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->cameras, result->cameras);
  EXPECT_EQ(again->covariance.matrix, result->covariance.matrix);
}

TEST(BundleAdjustment, TheCovarianceForetellsTheErrors) {
  // Distances between cameras do not depend on the choice of the world. Over 24 noisy repetitions
  // the mean squared error in predicted standard deviations is 1 up to sqrt(2/24/few) or so.
  const CameraRig rig = fourCameras();
  BundleProblem clean = wavedProblem(rig, true, 30);
  double sum = 0.0;
  int count = 0;
  for (std::uint32_t seed = 0; seed < 24; ++seed) {
    BundleProblem problem = clean;
    const RandomStream random(11, seed, 0, RandomPurpose::Noise);
    for (std::size_t i = 0; i < problem.observations.size(); ++i) {
      const auto draw = random.normal4(std::uint32_t(i));
      problem.observations[i].pixel += 0.3 * Eigen::Vector2d(draw[0], draw[1]);
      problem.observations[i].sigma = 0.3;
    }
    const auto result = adjustBundle(problem);
    ASSERT_TRUE(result) << errorSentence(result.error());
    EXPECT_NEAR(result->residualToSigmaRatio, 1.0, 0.15);
    for (std::size_t c = 1; c < rig.size(); ++c) {
      const Eigen::Vector3d way = result->cameras[c].center() - result->cameras[0].center();
      const double error = way.norm() - (rig[c].center() - rig[0].center()).norm();
      Eigen::VectorXd slope = Eigen::VectorXd::Zero(result->covariance.matrix.rows());
      slope.segment<3>(3) = -way.normalized();
      slope.segment<3>(Eigen::Index(6 * c + 3)) = way.normalized();
      sum += error * error / slope.dot(result->covariance.matrix * slope);
      ++count;
    }
  }
  EXPECT_GT(sum / count, 0.6);
  EXPECT_LT(sum / count, 1.5);
}

TEST(BundleAdjustment, FindsFocalLengthsAndALens) {
  CameraRig rig = fourCameras();
  for (Camera& camera : rig) {
    camera.distortion[0] = -0.08;
  }
  BundleProblem problem = wavedProblem(rig, true, 120);
  for (BundleCamera& camera : problem.cameras) {
    camera.camera.intrinsics.focalX *= 1.03;
    camera.camera.intrinsics.focalY *= 1.03;
    camera.camera.distortion[0] = 0.0;
    camera.isFocalFree = true;
    camera.isDistortionFree[0] = true;
  }
  const auto result = adjustBundle(problem);
  ASSERT_TRUE(result) << errorSentence(result.error());
  for (const Camera& camera : result->cameras) {
    EXPECT_NEAR(camera.intrinsics.focalX, 500.0, 1e-3);
    EXPECT_NEAR(camera.intrinsics.focalY, 510.0, 1e-3);
    EXPECT_NEAR(camera.distortion[0], -0.08, 1e-5);
  }
}

TEST(BundleAdjustment, FindsTimeOffsets) {
  const CameraRig rig = fourCameras();
  const std::vector<double> offsets{0.0, 0.012, -0.016, 0.005};
  BundleProblem problem = wavedProblem(rig, true, 90, 0.0, offsets);
  for (std::size_t c = 1; c < rig.size(); ++c) {
    problem.cameras[c].isTimeOffsetFree = true;
  }
  const auto result = adjustBundle(problem);
  ASSERT_TRUE(result) << errorSentence(result.error());
  for (std::size_t c = 0; c < rig.size(); ++c) {
    // What a quartic through instants 33 ms apart misses of this motion is below 1e-5 m.
    EXPECT_NEAR(result->timeOffsets[c], offsets[c], 2e-5);
  }
  EXPECT_LT(result->rmsPx, 0.01);
}

TEST(BundleAdjustment, ABoardOnTheFloorIsTheWorld) {
  const CameraRig rig = fourCameras();
  BundleProblem problem;
  problem.cameras = nudged(rig);
  BundleBody board{"board", BundleBody::Kind::Board};
  for (int i = 0; i < 12; ++i) {
    board.points.emplace_back(0.1 * (i % 4) - 0.15, 0.1 * int(i / 4) - 0.1, 0.0);
  }
  problem.bodies.push_back(board);
  for (int f = 0; f < 6; ++f) {
    BundleState state;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    if (f > 0) {
      pose.linear() = rotationExponential({0.2 * f, -0.1 * f, 0.3});
      pose.translation() << 0.05 * f, -0.1, 0.2 + 0.05 * f;
    }
    state.isPositionKnown = true;
    state.isFixed = f == 0;
    state.worldFromBoard = pose;
    for (std::size_t c = 0; c < rig.size(); ++c) {
      for (std::size_t p = 0; p < board.points.size(); ++p) {
        problem.observations.push_back(
            {c, problem.states.size(), p, *Projector(rig[c]).project(pose * board.points[p])});
      }
    }
    if (f > 0) {
      state.worldFromBoard.translation().x() += 0.02;
    }
    problem.states.push_back(state);
  }
  const auto result = adjustBundle(problem);
  ASSERT_TRUE(result) << errorSentence(result.error());
  for (std::size_t c = 0; c < rig.size(); ++c) {
    EXPECT_LT(distance(result->cameras[c], rig[c]), 1e-7);
  }
  EXPECT_EQ(result->covariance.gaugeFreedomCount, 0);
}

TEST(BundleAdjustment, ARobustLossBearsGrossErrors) {
  const CameraRig rig = fourCameras();
  BundleProblem problem = wavedProblem(rig, true, 60);
  for (std::size_t i = 0; i < problem.observations.size(); i += 23) {
    problem.observations[i].pixel.x() += 40.0;
  }
  problem.loss = RobustLoss::Cauchy;
  problem.lossWidth = 1.0;
  const auto result = adjustBundle(problem);
  ASSERT_TRUE(result) << errorSentence(result.error());
  for (std::size_t c = 1; c < rig.size(); ++c) {
    EXPECT_NEAR(distance(result->cameras[c], result->cameras[0]), distance(rig[c], rig[0]), 2e-3);
  }
}

TEST(BundleAdjustment, TheMiddleOfABallsOutlineIsCorrected) {
  const CameraRig rig = fourCameras();
  BundleProblem problem = wavedProblem(rig, true, 40);
  const double radius = 0.1;
  for (BundleObservation& seen : problem.observations) {
    const double t = problem.states[seen.state].time;
    const Eigen::Vector3d ball =
        wavedBall(t) +
        0.5 * double(seen.point) * Eigen::Vector3d(std::cos(2.0 * t), std::sin(2.0 * t), 0.0);
    const SphereProjector sphere(rig[seen.camera]);
    seen.pixel = sphere.project(ball, radius)->center;
    seen.outlineShift = std::pow(radius / sphere.depth(ball), 2);
  }
  const auto result = adjustBundle(problem);
  ASSERT_TRUE(result) << errorSentence(result.error());
  EXPECT_LT(result->rmsPx, 1e-6);
}

TEST(BundleAdjustment, SaysWhatIsMissing) {
  const CameraRig rig = fourCameras();
  BundleProblem few = wavedProblem(rig, false, 30);
  std::erase_if(few.observations, [](const auto& seen) { return seen.camera == 2; });
  const auto refused = adjustBundle(few);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Undetermined);
  EXPECT_EQ(refused.error().field, "c");

  // A ball at rest says nothing about where four cameras are.
  BundleProblem still = wavedProblem(rig, false, 30);
  for (BundleObservation& seen : still.observations) {
    seen.pixel = *Projector(rig[seen.camera]).project(wavedBall(0.0));
  }
  EXPECT_EQ(adjustBundle(still).error().code, ErrorCode::Undetermined);

  BundleProblem bad = wavedProblem(rig, false, 30);
  bad.observations[5].pixel.x() = std::nan("");
  EXPECT_EQ(adjustBundle(bad).error().field, "observations");
}

TEST(BundleAdjustment, StopsWhenAsked) {
  const auto result = adjustBundle(wavedProblem(fourCameras(), true, 30),
                                   [](const BundleProgress& now) { return now.iteration < 1; });
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::Canceled);
}

} // namespace
} // namespace dewpoint::tests
