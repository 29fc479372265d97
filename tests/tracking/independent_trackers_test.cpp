// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/barrera/barrera_tracker.h"
#include "core/tracking/barrera/dynamics_tracker.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/independent_trackers.h"
#include "core/tracking/start_parameters.h"
#include "tests/tracking/drawn_run.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

using drawn::Ball;
using drawn::parametersOf;
using drawn::redBall;

TEST(MethodCatalog, KnowsEveryMethod) {
  const CameraRig rig = drawn::rigAround(2);
  for (const std::string& method : methodNames(TargetSource::Color)) {
    const auto tracker =
        makeTracker(method, parametersOf(method.c_str()), rig, {redBall(), redBall()});
    ASSERT_TRUE(tracker) << method;
    EXPECT_EQ((*tracker)->trackCount(), 2U) << method;
    EXPECT_FALSE(sphereOf(**tracker).isValid) << method;
  }
}

TEST(MethodCatalog, UnknownMethodOrParametersOfAnotherAreRefused) {
  const auto unknown = makeTracker("kalman", parametersOf("dewpoint"), {}, {redBall()});
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::NotFound);
  for (const std::string& method : methodNames(TargetSource::Color)) {
    const std::string other = method == "dewpoint" ? "barrera" : "dewpoint";
    const auto missing = makeTracker(method, parametersOf(other.c_str()), {}, {redBall()});
    ASSERT_FALSE(missing) << method;
    EXPECT_EQ(missing.error().code, ErrorCode::MissingKey) << method;
  }
}

// Each is what a tracker of its own, started from derivedSeed(seed, k), would be: to the bit.
TEST(IndependentTrackers, NoneKnowsOfTheOthers) {
  const CameraRig rig = drawn::rigAround(2);
  const auto values = parametersOf("barrera", {{"start_x", 0.5}, {"start_y", 0.5}});
  auto together = makeTracker("barrera", values, rig, {redBall(), redBall(), redBall()});
  ASSERT_TRUE(together);
  (*together)->restart(42);
  ThreadTeam team;
  std::vector<BarreraTracker> alone;
  for (std::uint32_t k = 0; k < 3; ++k) {
    alone.emplace_back(values, rig, redBall());
    alone.back().restart(derivedSeed(42, k));
  }
  for (int frame = 0; frame < 5; ++frame) {
    const auto frames = drawn::framesOf(rig, {Ball{drawn::kMiddle}}, frame);
    (*together)->beginFrame(frames);
    (*together)->iterate(team);
    for (std::size_t k = 0; k < 3; ++k) {
      alone[k].beginFrame(frames);
      const SphereEstimate expected = alone[k].iterate(team);
      EXPECT_EQ(sphereOf(**together, k).mean, expected.mean);
      EXPECT_EQ(sphereOf(**together, k).covariance, expected.covariance);
    }
  }
  EXPECT_NE(sphereOf(**together).mean, sphereOf(**together, 1).mean);
  Eigen::ArrayXXd ours;
  Eigen::ArrayXXd theirs;
  Eigen::ArrayXd weights;
  capability<ParticleCloud>(**together)->copyParticles(2, 50, ours, weights);
  alone[2].copyParticles(50, theirs, weights);
  EXPECT_TRUE((ours == theirs).all());
  (*together)->restart(42);
  EXPECT_FALSE(sphereOf(**together).isValid);
}

TEST(IndependentTrackers, TakeTargetsAndParametersOfAll) {
  const CameraRig rig = drawn::rigAround(2);
  auto tracker = makeTracker("barrera", parametersOf("barrera"), rig, {redBall(), redBall()});
  ASSERT_TRUE(tracker);
  capability<Configurable>(**tracker)->configure(
      parametersOf("barrera", {{"iterations_per_frame", 9}, {"particles", 70}}));
  EXPECT_EQ((*tracker)->iterationsPerFrame(), 9);
  capability<TargetTracking>(**tracker)->setTargets(
      {redBall()}); // fewer than there are: the others stay
  EXPECT_EQ(capability<FixedTargetCount>(**tracker)->targetCount(), 2U);
  ThreadTeam team;
  (*tracker)->beginFrame(drawn::framesOf(rig, {}, 0));
  (*tracker)->iterate(team);
  EXPECT_EQ(sphereOf(**tracker, 1).particleCount, 70);
  const auto none = makeTracker("barrera", parametersOf("barrera"), rig, {});
  ASSERT_TRUE(none);
  EXPECT_EQ((*none)->iterationsPerFrame(), 0);
}

// A filter without likelihoods of its own has no maps, rather than empty ones.
TEST(IndependentTrackers, HaveLikelihoodMapsWhereTheirFiltersHave) {
  const CameraRig rig = drawn::rigAround(2);
  const auto barrera = makeTracker("barrera", parametersOf("barrera"), rig, {redBall()}).value();
  const auto dynamics = makeTracker("dynamics", parametersOf("dynamics"), rig, {redBall()}).value();
  ASSERT_NE(capability<LikelihoodMapping>(*barrera), nullptr);
  EXPECT_EQ(capability<LikelihoodMapping>(*dynamics), nullptr);
  const auto copy = capability<Copyable>(*barrera)->clone();
  EXPECT_NE(capability<LikelihoodMapping>(*copy), nullptr);
}

TEST(StartParameters, DeclareAVolumeAndGiveItBack) {
  const StartVolume defaults{{1.0, -2.0, 0.5}, {0.25, 0.0, 3.0}};
  const auto declarations = startParameters(defaults);
  ASSERT_EQ(declarations.size(), 6U);
  ParameterValues values{std::span<const ParameterDeclaration>(declarations)};
  EXPECT_EQ(startVolumeOf(values).center, defaults.center);
  EXPECT_EQ(startVolumeOf(values).halfSize, defaults.halfSize);
  EXPECT_TRUE(values.set("start_y", 7.0));
  EXPECT_TRUE(values.set("start_half_x", 1.5));
  EXPECT_EQ(startVolumeOf(values).center, Eigen::Vector3d(1.0, 7.0, 0.5));
  EXPECT_EQ(startVolumeOf(values).halfSize, Eigen::Vector3d(1.5, 0.0, 3.0));
  EXPECT_FALSE(values.set("start_half_x", -0.1)); // a half size is not negative
}

} // namespace
} // namespace dewpoint::tests
