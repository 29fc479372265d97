// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/bundle/bundle_start.h"
#include "tests/calibration/bundle/bundle_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace dewpoint::tests {
namespace {

using abreast::ballAt;
using abreast::ballSeenAt;
using abreast::kSix;
using abreast::pixelOf;

using StateIndices = std::vector<std::size_t>;

/// Camera `camera` no longer sees the body in this state.
void hide(BundleProblem& problem, std::size_t state, std::size_t camera) {
  std::erase_if(problem.observations, [&](const BundleObservation& seen) {
    return seen.state == state && seen.camera == camera;
  });
}

/// The index of what `camera` sees of `state`.
std::size_t indexOf(const BundleProblem& problem, std::size_t state, std::size_t camera) {
  const auto found = std::ranges::find_if(problem.observations, [&](const auto& seen) {
    return seen.state == state && seen.camera == camera;
  });
  return static_cast<std::size_t>(found - problem.observations.begin());
}

TEST(BundleStart, FreePointsAreTriangulated) {
  // By hand: the ball at (0.2, 0.1, 4) is at (345, 252.5) and (220, 252.5).
  const BundleProblem problem = ballSeenAt(kSix);
  EXPECT_EQ(problem.observations[0].pixel, Eigen::Vector2d(345.0, 252.5));
  EXPECT_EQ(problem.observations[1].pixel, Eigen::Vector2d(220.0, 252.5));
  const auto start = initializeBundle(problem);
  ASSERT_TRUE(start) << errorSentence(start.error());
  for (std::size_t k = 0; k < kSix.size(); ++k) {
    EXPECT_TRUE(start->isStateUsed[k]);
    EXPECT_LT((start->states[k].ends[0] - ballAt(kSix[k])).norm(), 1e-9) << k;
  }
  EXPECT_EQ(std::ranges::count(start->isObservationUsed, true), 12);
  EXPECT_FALSE(start->hasInterpolation); // all images are of their states' instants
}

TEST(BundleStart, AStartThatIsKnownIsKept) {
  BundleProblem problem = ballSeenAt(kSix);
  problem.states[2].isPositionKnown = true;
  problem.states[2].ends[0] = {9.0, 9.0, 9.0};
  const auto start = initializeBundle(problem);
  ASSERT_TRUE(start);
  EXPECT_EQ(start->states[2].ends[0], Eigen::Vector3d(9.0, 9.0, 9.0));
}

TEST(BundleStart, WhatOneCameraSeesSaysNothing) {
  BundleProblem problem = ballSeenAt({0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6});
  hide(problem, 3, 1);
  const auto start = initializeBundle(problem);
  ASSERT_TRUE(start) << errorSentence(start.error());
  EXPECT_FALSE(start->isStateUsed[3]);
  EXPECT_FALSE(start->isObservationUsed[indexOf(problem, 3, 0)]);
  EXPECT_EQ(std::ranges::count(start->isStateUsed, true), 6);
  // Unless the world is defined by it.
  problem.states[3].isFixed = true;
  const auto fixed = initializeBundle(problem);
  ASSERT_TRUE(fixed);
  EXPECT_TRUE(fixed->isStateUsed[3]);
}

TEST(BundleStart, BothEndsOfAStickMustBeSeenByTwoCameras) {
  BundleProblem problem = ballSeenAt(kSix);
  problem.bodies[0].kind = BundleBody::Kind::Stick;
  problem.bodies[0].length = 0.5;
  for (std::size_t k = 0; k < kSix.size(); ++k) { // the other end, 0.5 m to the right
    for (std::size_t c = 0; c < 2; ++c) {
      BundleObservation seen = problem.observations[2 * k + c];
      seen.point = 1;
      seen.pixel = pixelOf(double(c), ballAt(kSix[k]) + Eigen::Vector3d(0.5, 0.0, 0.0));
      problem.observations.push_back(seen);
    }
  }
  const auto start = initializeBundle(problem);
  ASSERT_TRUE(start) << errorSentence(start.error());
  EXPECT_LT((start->states[1].ends[1] - ballAt(0.1) - Eigen::Vector3d(0.5, 0.0, 0.0)).norm(), 1e-9);
  problem.observations.pop_back(); // of the last state's other end
  const auto fewer = initializeBundle(problem);
  ASSERT_TRUE(fewer) << errorSentence(fewer.error());
  EXPECT_FALSE(fewer->isStateUsed[5]);
  EXPECT_TRUE(fewer->isStateUsed[4]);
}

TEST(BundleStart, ABoardNeedsFourPoints) {
  BundleProblem problem;
  problem.cameras = {abreast::cameraAt(0.0)};
  problem.bodies.push_back({"board", BundleBody::Kind::Board});
  problem.bodies[0].points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 0}};
  for (std::size_t k = 0; k < 2; ++k) {
    BundleState state;
    state.time = double(k);
    state.isPositionKnown = true;
    state.worldFromBoard.translation() = Eigen::Vector3d(0.0, 0.0, 5.0);
    problem.states.push_back(state);
    for (std::size_t point = 0; point < (k == 0 ? 6U : 3U); ++point) {
      BundleObservation seen;
      seen.state = k;
      seen.point = point;
      seen.pixel = pixelOf(0.0, state.worldFromBoard * problem.bodies[0].points[point]);
      problem.observations.push_back(seen);
    }
  }
  const auto start = initializeBundle(problem);
  ASSERT_TRUE(start) << errorSentence(start.error());
  EXPECT_TRUE(start->isStateUsed[0]); // one camera is enough for a board
  EXPECT_FALSE(start->isStateUsed[1]);
  problem.states[0].isPositionKnown = false;
  const auto nowhere = initializeBundle(problem);
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().field, "board");
}

TEST(BundleStart, ACameraThatIsNotKnownNeedsSixObservations) {
  BundleProblem problem = ballSeenAt({0.0, 0.1, 0.2, 0.3, 0.4});
  const auto few = initializeBundle(problem);
  ASSERT_FALSE(few);
  EXPECT_EQ(few.error().code, ErrorCode::Undetermined);
  EXPECT_EQ(few.error().field, "camera 1");
  EXPECT_NE(few.error().detail.find("5 usable observations, at least 6"), std::string::npos);
  problem.cameras[0].isPoseFixed = true;
  EXPECT_EQ(initializeBundle(problem).error().field, "camera 2");
  problem.cameras[1].posePrior = PosePrior{};
  EXPECT_TRUE(initializeBundle(problem));
  problem.observations.clear(); // known, but nothing is seen
  const auto nothing = initializeBundle(problem);
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().code, ErrorCode::Undetermined);
  EXPECT_EQ(nothing.error().field, "observations");
}

/// The instants a point is followed through, around each state, for images that are late.
std::vector<StateIndices> knotsOf(const std::vector<double>& times) {
  BundleProblem problem = ballSeenAt(times);
  problem.cameras[1].isTimeOffsetFree = true;
  problem.cameras[0].isPoseFixed = problem.cameras[1].isPoseFixed = true;
  const auto start = initializeBundle(problem);
  EXPECT_TRUE(start);
  std::vector<StateIndices> knots;
  for (std::size_t k = 0; start && k < times.size(); ++k) {
    EXPECT_TRUE(
        start->interpolationStates[indexOf(problem, k, 0)].empty()); // this camera is on time
    knots.push_back(start->interpolationStates[indexOf(problem, k, 1)]);
  }
  EXPECT_TRUE(start && start->hasInterpolation);
  return knots;
}

TEST(BundleStart, APointIsFollowedThroughFiveInstants) {
  // The two before and the two behind; at the ends of the path the nearest five.
  EXPECT_EQ(knotsOf({0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6}),
            (std::vector<StateIndices>{{0, 1, 2, 3, 4},
                                       {0, 1, 2, 3, 4},
                                       {0, 1, 2, 3, 4},
                                       {1, 2, 3, 4, 5},
                                       {2, 3, 4, 5, 6},
                                       {2, 3, 4, 5, 6},
                                       {2, 3, 4, 5, 6}}));
}

TEST(BundleStart, APathIsNotFollowedThroughALongGap) {
  // 0.5 s, where 0.2 s are allowed: four instants before it, three behind it.
  EXPECT_EQ(knotsOf({0.0, 0.1, 0.2, 0.3, 0.8, 0.9, 1.0}), (std::vector<StateIndices>{{0, 1, 2, 3},
                                                                                     {0, 1, 2, 3},
                                                                                     {0, 1, 2, 3},
                                                                                     {0, 1, 2, 3},
                                                                                     {4, 5, 6},
                                                                                     {4, 5, 6},
                                                                                     {4, 5, 6}}));
}

// Behind the gap there are two instants, a path needs three: what the late camera sees of them is
// dropped, so that the other one alone sees them, so that these two states are dropped with what
// the other one saw.
TEST(BundleStart, WhatLosesItsSupportIsDroppedRoundAfterRound) {
  BundleProblem problem = ballSeenAt({0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 1.0, 1.1});
  problem.cameras[1].isTimeOffsetFree = true;
  const auto start = initializeBundle(problem);
  ASSERT_TRUE(start) << errorSentence(start.error());
  for (const std::size_t state : {6U, 7U}) {
    EXPECT_FALSE(start->isStateUsed[state]);
    EXPECT_FALSE(start->isObservationUsed[indexOf(problem, state, 0)]);
    EXPECT_FALSE(start->isObservationUsed[indexOf(problem, state, 1)]);
  }
  EXPECT_EQ(std::ranges::count(start->isStateUsed, true), 6);
  EXPECT_EQ(std::ranges::count(start->isObservationUsed, true), 12);
}

TEST(BundleStart, SenselessNumbersAreRefused) {
  const auto fieldOf = [](const auto& change) {
    BundleProblem problem = ballSeenAt(kSix);
    change(problem);
    const auto start = initializeBundle(problem);
    EXPECT_FALSE(start);
    EXPECT_EQ(start.error().code, ErrorCode::BadValue);
    return start.error().field;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fieldOf([](auto& p) { p.states[0].body = 1; }), "states");
  EXPECT_EQ(fieldOf([&](auto& p) { p.states[0].time = nan; }), "states");
  EXPECT_EQ(fieldOf([](auto& p) { p.observations[0].camera = 2; }), "observations");
  EXPECT_EQ(fieldOf([](auto& p) { p.observations[0].state = 6; }), "observations");
  EXPECT_EQ(fieldOf([](auto& p) { p.observations[0].point = 1; }), "observations");
  EXPECT_EQ(fieldOf([&](auto& p) { p.observations[0].pixel.x() = nan; }), "observations");
  EXPECT_EQ(fieldOf([](auto& p) { p.observations[0].sigma = 0.0; }), "observations");
  EXPECT_EQ(fieldOf([&](auto& p) { p.observations[0].timeAfterState = nan; }), "observations");
}

} // namespace
} // namespace dewpoint::tests
