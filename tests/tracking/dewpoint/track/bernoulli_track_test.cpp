// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/bernoulli_track.h"
#include "core/tracking/dewpoint/track/region_track.h"
#include "tests/observation/drawn_ellipsoids.h"
#include "tests/observation/drawn_spheres.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

namespace dewpoint::tests {
namespace {

using drawn::Ball;
using drawn::kFrame;
using drawn::kRadius;

const Eigen::Vector3d kThere = drawn::kMiddle;

/// A track in front of two cameras that have no image until show(): until then it changes by the
/// passing of time alone, because the likelihood is flat.
class BernoulliTrackTest : public ::testing::Test {
protected:
  BernoulliTrackTest()
      : rig_(drawn::rigAround(2, 2)), backgrounds_(2), images_(2), observation_(rig_),
        track_(Target{"ball", kRadius, drawn::kRed}) {
    for (std::size_t k = 0; k < rig_.size(); ++k) {
      for (int frame = 0; frame < 20; ++frame) {
        backgrounds_[k].learn(drawn::wall(rig_[k]), {});
      }
    }
    BernoulliTrackSettings settings;
    settings.accelerationSigma = 8.0;
    track_.configure(settings);
    track_.restart(StartVolume{kThere, Eigen::Vector3d::Constant(0.5)}, 1);
  }
  void show(const std::vector<Ball>& balls) {
    for (std::size_t k = 0; k < rig_.size(); ++k) {
      images_[k] = drawn::draw(rig_[k], balls);
      observation_.setImage(k, images_[k], 0.0, backgrounds_[k], classifier_);
    }
  }
  void initializeAt(const Eigen::Vector3d& position = kThere) {
    track_.initializeAt(position, kRadius, observation_, key_, team_);
  }
  void predict(double interval) {
    track_.predict(interval, key_);
    ++key_.frame;
  }
  /// Another frame, in which the search finds `candidates`.
  void update(std::vector<Candidate> candidates = {},
              const std::vector<OccupiedSphere>& occupied = {}) {
    const auto search = [&](SphereObservation&, bool, std::size_t) {
      ++searches_;
      return candidates;
    };
    track_.update(observation_, search, occupied, key_, team_);
  }
  double probability() const { return track_.mostLikelyHypothesis()->probability; }

  CameraRig rig_;
  ColorClassifier classifier_{drawn::kRed};
  std::vector<BackgroundModel> backgrounds_;
  std::vector<cv::Mat> images_;
  SphereObservation observation_;
  BernoulliTrack track_;
  ThreadTeam team_;
  RandomKey key_{11, 0, 0};
  int searches_ = 0;
};

// An initialized hypothesis has 0.98. After 1 s of a survival time of 5 s, e^-0.2 of it is left; a
// measurement without images changes nothing: absence takes the rest.
TEST_F(BernoulliTrackTest, WithoutImagesExistenceDecaysWithTheSurvivalTime) {
  initializeAt();
  EXPECT_EQ(probability(), 0.98);
  predict(1.0);
  EXPECT_NEAR(probability(), 0.98 * std::exp(-0.2), 1e-12);
  update();
  EXPECT_NEAR(probability(), 0.98 * std::exp(-0.2), 1e-9);
  EXPECT_NE(track_.confidentHypothesis(), nullptr);
  // A second iteration on the same frame counts nothing twice.
  update();
  EXPECT_NEAR(probability(), 0.98 * std::exp(-0.2), 1e-9);
  predict(2.5); // 3.5 s in all: e^-0.7, less than one half
  update();
  EXPECT_NEAR(probability(), 0.98 * std::exp(-0.7), 1e-9);
  EXPECT_EQ(track_.confidentHypothesis(), nullptr);
}

TEST_F(BernoulliTrackTest, WhatNobodyCanSeeIsSearchedFor) {
  initializeAt();
  predict(kFrame);
  update();
  EXPECT_EQ(searches_, 1);
  track_.setCreatesHypotheses(false);
  update();
  EXPECT_EQ(searches_, 1);
}

TEST_F(BernoulliTrackTest, WhatIsFullySeenIsNotSearchedFor) {
  show({Ball{kThere}});
  initializeAt();
  predict(kFrame);
  update();
  EXPECT_EQ(searches_, 0);
  EXPECT_GT(probability(), 0.999);
}

// 0.98 e^-0.2 = 0.80 is likelier than not, 0.98 e^-0.8 = 0.44 is not. Radii of 35 mm and 0.7 of
// their sum: 49 mm.
TEST_F(BernoulliTrackTest, AnOccupiedPositionIsRemovedUnlessItIsLikelierThanNot) {
  const auto besideBy = [](double distance) {
    return std::vector{OccupiedSphere{kThere + Eigen::Vector3d(distance, 0.0, 0.0), kRadius}};
  };
  initializeAt();
  predict(1.0);
  track_.removeOccupied(besideBy(0.0));
  EXPECT_NE(track_.mostLikelyHypothesis(), nullptr);
  initializeAt();
  predict(4.0);
  track_.removeOccupied(besideBy(0.050));
  ASSERT_NE(track_.mostLikelyHypothesis(), nullptr);
  track_.removeOccupied(besideBy(0.048));
  EXPECT_EQ(track_.mostLikelyHypothesis(), nullptr);
  update(); // what was predicted for this frame is removed too
  EXPECT_EQ(track_.mostLikelyHypothesis(), nullptr);
}

TEST_F(BernoulliTrackTest, WhatIsSuppressedHasAThousandthLeft) {
  initializeAt();
  track_.suppressBestHypothesis();
  EXPECT_NEAR(probability(), 0.98e-3, 1e-15);
  track_.restart({}, 2);
  track_.suppressBestHypothesis(); // nothing to suppress
  EXPECT_EQ(track_.mostLikelyHypothesis(), nullptr);
}

// No hypothesis is left, the target appears with 0.2 within a frame, and a fully seen ball has by
// far more evidence than any volume takes away.
TEST_F(BernoulliTrackTest, ATrackIsCreatedWhereTheSearchFindsIt) {
  show({Ball{kThere}});
  predict(kFrame);
  update({{kThere + Eigen::Vector3d(0.004, 0.0, 0.0), kRadius, 0.0}});
  ASSERT_NE(track_.confidentHypothesis(), nullptr);
  EXPECT_LT((track_.mostLikelyHypothesis()->position() - kThere).norm(), 1e-3);
  EXPECT_TRUE(track_.expectedSphere());
}

TEST_F(BernoulliTrackTest, NoTrackIsCreatedAtAnOccupiedPositionNorTwiceAtOne) {
  show({Ball{kThere}});
  const Candidate here{kThere, kRadius, 0.0};
  predict(kFrame);
  update({here}, {{kThere, kRadius}});
  EXPECT_EQ(track_.mostLikelyHypothesis(), nullptr);
  update({here, here});
  EXPECT_EQ(track_.hypotheses().size(), 1U);
}

/// All positions whose x is at least `x` meters beyond that of kThere, within a meter.
WorldBox boundsFrom(double x) {
  return {kThere + Eigen::Vector3d(x, -1.0, -1.0), kThere + Eigen::Vector3d(1.0, 1.0, 1.0)};
}

TEST_F(BernoulliTrackTest, NoTrackIsCreatedOutsideTheBounds) {
  show({Ball{kThere}});
  track_.setBounds(boundsFrom(0.05));
  predict(kFrame);
  update({{kThere, kRadius, 0.0}});
  EXPECT_EQ(track_.mostLikelyHypothesis(), nullptr);
  const SphereEstimate searched = track_.estimate(observation_);
  EXPECT_FALSE(searched.isValid);
  EXPECT_TRUE(boundsFrom(0.05).contains(searched.mean, 1e-9)) << searched.mean.transpose();
  track_.setBounds(boundsFrom(-1.0));
  update({{kThere, kRadius, 0.0}});
  EXPECT_NE(track_.confidentHypothesis(), nullptr);
}

TEST_F(BernoulliTrackTest, ATrackEndsMoreThanARadiusOutsideTheBounds) {
  initializeAt();
  predict(kFrame);
  track_.setBounds(boundsFrom(0.9 * kRadius));
  update();
  EXPECT_NE(track_.mostLikelyHypothesis(), nullptr);
  track_.setBounds(boundsFrom(1.1 * kRadius));
  update();
  EXPECT_EQ(track_.mostLikelyHypothesis(), nullptr);
}

TEST_F(BernoulliTrackTest, StartsWithinTheBounds) {
  track_.setBounds(boundsFrom(0.2));
  track_.restart(StartVolume{kThere, Eigen::Vector3d::Constant(0.5)}, 1);
  Eigen::ArrayXXd positions;
  Eigen::ArrayXd weights;
  track_.copyParticles(1000, positions, weights);
  ASSERT_GT(positions.rows(), 0);
  EXPECT_GE(positions.col(0).minCoeff(), kThere.x() + 0.2);
  EXPECT_LE(positions.col(0).maxCoeff(), kThere.x() + 0.5 + 1e-12);
}

// What was measured before it was lost says that a ball of half the size is another.
TEST_F(BernoulliTrackTest, RemembersTheRadiusThatItMeasured) {
  const double half = 0.5 * kRadius;
  const Eigen::Vector3d elsewhere = kThere + Eigen::Vector3d(0.2, 0.1, 0.0);
  track_.setTarget(Target{"ball", 0.0, drawn::kRed});
  show({Ball{elsewhere, half}});
  predict(kFrame);
  update({{elsewhere, half, 0.0}});
  ASSERT_NE(track_.confidentHypothesis(), nullptr); // nothing is known yet
  EXPECT_NEAR(track_.mostLikelyHypothesis()->radius, half, 0.1 * half);

  track_.restart(StartVolume{kThere, Eigen::Vector3d::Constant(0.5)}, 1);
  show({Ball{kThere}});
  for (int frame = 0; frame < 10; ++frame) {
    predict(kFrame);
    update({{kThere, kRadius, 0.0}});
  }
  ASSERT_NE(track_.confidentHypothesis(), nullptr);
  EXPECT_NEAR(track_.mostLikelyHypothesis()->radius, kRadius, 0.03 * kRadius);
  show({Ball{elsewhere, half}});
  for (int frame = 0; frame < 10; ++frame) {
    predict(kFrame);
    update({{elsewhere, half, 0.0}});
  }
  EXPECT_EQ(track_.confidentHypothesis(), nullptr);
}

// The target was followed as something of another shape, and is taken for a ball again: its
// hypothesis and those that are created beside it must not be taken for each other. One camera sees
// it covered, so that it is searched for elsewhere.
TEST_F(BernoulliTrackTest, AHypothesisFromElsewhereSharesItsNumberWithNone) {
  drawn::RegionScene scene(rig_);
  scene.show({drawn::ellipsoid(kThere, Eigen::Vector3d::Constant(kRadius), 0.0)});
  RegionTrack region(track_.target());
  const Eigen::Matrix3d extent = kRadius * kRadius * Eigen::Matrix3d::Identity();
  region.startAt({kThere, 0.01 * extent}, extent, false, scene.observation(), key_, team_);
  ASSERT_NE(region.hypothesis(), nullptr);
  track_.setOnlyHypothesis(region.hypothesis());

  const Eigen::Vector3d camera = rig_[0].cameraFromWorld.inverse() * Eigen::Vector3d::Zero();
  const Ball cover{0.5 * (camera + kThere), kRadius, {0, 230, 0}};
  const Eigen::Vector3d left = kThere + Eigen::Vector3d(-0.2, 0.0, 0.0);
  const Eigen::Vector3d right = kThere + Eigen::Vector3d(0.0, 0.2, 0.0);
  show({Ball{kThere}, Ball{left}, Ball{right}, cover});
  predict(kFrame);
  update({{left, kRadius, 0.0}, {right, kRadius, 0.0}});
  std::set<std::uint32_t> numbers;
  for (const TrackHypothesis& hypothesis : track_.hypotheses()) {
    numbers.insert(hypothesis.streamNumber);
  }
  EXPECT_TRUE(numbers.contains(region.hypothesis()->streamNumber));
  EXPECT_EQ(track_.hypotheses().size(), 3U);
  EXPECT_EQ(numbers.size(), 3U);
}

/// Two equal balls side by side, as far from the middle of the start volume: nothing tells which is
/// the target.
class TwoEqualBalls : public BernoulliTrackTest {
protected:
  TwoEqualBalls() {
    show({Ball{left_}, Ball{right_}});
    for (int frame = 0; frame < 8; ++frame) {
      predict(kFrame);
      update({{left_, kRadius, 0.0}, {right_, kRadius, 0.0}});
    }
  }
  const Eigen::Vector3d left_ = kThere + Eigen::Vector3d(-0.1, 0.1, 0.0);
  const Eigen::Vector3d right_ = kThere + Eigen::Vector3d(0.1, -0.1, 0.0);
};

// The ambiguity is the share that the rival had; the estimate's existence is what is left of the
// sum.
TEST_F(TwoEqualBalls, AreResolvedAndTheAmbiguityStays) {
  ASSERT_EQ(track_.hypotheses().size(), 2U);
  const double first = track_.hypotheses()[0].probability;
  const double second = track_.hypotheses()[1].probability;
  track_.resolveIdentity(false);
  ASSERT_EQ(track_.hypotheses().size(), 1U);
  EXPECT_NEAR(probability(), first + second, 1e-12);
  const SphereEstimate estimate = track_.estimate(observation_);
  EXPECT_NEAR(estimate.existenceProbability, first,
              1e-9); // (first + second) (1 - second / (first + second))
  EXPECT_TRUE(estimate.isValid);
  update(); // the rival is gone for good
  EXPECT_EQ(track_.hypotheses().size(), 1U);
}

TEST_F(TwoEqualBalls, AreBothRightWhereBothAreTargets) {
  const double both = track_.hypotheses()[0].probability + track_.hypotheses()[1].probability;
  track_.resolveIdentity(true);
  ASSERT_EQ(track_.hypotheses().size(), 1U);
  EXPECT_NEAR(track_.estimate(observation_).existenceProbability, both, 1e-9);
}

TEST_F(BernoulliTrackTest, ForgetsEverythingAtARestart) {
  initializeAt();
  predict(kFrame);
  EXPECT_TRUE(track_.expectedSphere());
  track_.restart({}, 3);
  EXPECT_TRUE(track_.hypotheses().empty());
  EXPECT_FALSE(track_.expectedSphere());
  EXPECT_FALSE(track_.estimate(observation_).isValid);
}

} // namespace
} // namespace dewpoint::tests
