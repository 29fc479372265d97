// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/sphere/sphere_evidence.h"
#include "core/tracking/dewpoint/search/candidate_search.h"
#include "core/tracking/dewpoint/search/sliced_search.h"
#include "tests/observation/drawn_spheres.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dewpoint::tests {
namespace {

using drawn::Ball;
using drawn::kRadius;

/// Cameras around the desk and what they see.
class SearchScene {
public:
  explicit SearchScene(int cameras)
      : rig_(drawn::rigAround(cameras)), backgrounds_(rig_.size()), images_(rig_.size()),
        observation_(rig_), search_(rig_) {
    for (std::size_t k = 0; k < rig_.size(); ++k) {
      for (int frame = 0; frame < 20; ++frame) {
        backgrounds_[k].learn(drawn::wall(rig_[k]), {});
      }
    }
  }
  void show(std::size_t camera, const std::vector<Ball>& balls) {
    images_[camera] = drawn::draw(rig_[camera], balls);
    drawn::addNoise(images_[camera], 3.0, 0, camera);
    observation_.setImage(camera, images_[camera], 0.0, backgrounds_[camera], classifier_);
  }
  void show(const std::vector<Ball>& balls) {
    for (std::size_t k = 0; k < rig_.size(); ++k) {
      show(k, balls);
    }
  }
  std::vector<Candidate> find(double radius = kRadius, std::size_t limit = 10) {
    observation_.setRadius(radius);
    return search_.find(observation_, radius > 0.0, limit);
  }
  SphereObservation& observation() { return observation_; }
  const CandidateSearch& search() const { return search_; }
  /// The same search in pieces, not yet begun.
  SlicedSearch inPieces(double radius = kRadius) {
    SlicedSearch sliced(rig_, AdaptiveColor(drawn::kRed, rig_.size()), radius, nullptr);
    for (std::size_t k = 0; k < rig_.size(); ++k) {
      sliced.observation().setImage(k, images_[k], 0.0, backgrounds_[k], classifier_);
    }
    return sliced;
  }

private:
  CameraRig rig_;
  ColorClassifier classifier_{drawn::kRed};
  std::vector<BackgroundModel> backgrounds_;
  std::vector<cv::Mat> images_;
  SphereObservation observation_;
  CandidateSearch search_;
};

bool isFound(const std::vector<Candidate>& candidates, const Eigen::Vector3d& position,
             double distance) {
  return std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& candidate) {
    return (candidate.center - position).norm() < distance;
  });
}

// The integer middle of a disc is up to a pixel off, 3.3 mm, in each of two images.
TEST(CandidateSearch, FindsABallInTwoCameras) {
  SearchScene scene(2);
  for (std::uint32_t k = 0; k < 20; ++k) {
    const Eigen::Vector3d truth = drawn::placeNear(k, 0.2);
    scene.show({Ball{truth, kRadius}});
    const auto candidates = scene.find();
    ASSERT_FALSE(candidates.empty()) << k;
    EXPECT_LT((candidates[0].center - truth).norm(), 0.3 * kRadius) << k;
    EXPECT_EQ(candidates[0].radius, kRadius);
    EXPECT_GT(candidates[0].logLikelihoodRatio,
              SphereEvidence::maxLogLikelihoodRatio()); // more than one camera could say
    EXPECT_EQ(scene.observation().radius(), kRadius);
  }
}

TEST(CandidateSearch, BestFirstAndNoTwoCloserThanARadius) {
  SearchScene scene(3);
  std::vector<Ball> balls;
  for (int k = 0; k < 5; ++k) {
    balls.push_back(
        {drawn::kMiddle + Eigen::Vector3d(-0.2 + 0.1 * k, 0.09 * (k % 2), 0.0), kRadius});
  }
  scene.show(balls);
  const auto candidates = scene.find(kRadius, 20);
  for (const Ball& ball : balls) {
    EXPECT_TRUE(isFound(candidates, ball.center, 0.5 * kRadius)) << ball.center.transpose();
  }
  for (std::size_t a = 0; a < candidates.size(); ++a) {
    for (std::size_t b = a + 1; b < candidates.size(); ++b) {
      EXPECT_GE(candidates[a].logLikelihoodRatio, candidates[b].logLikelihoodRatio);
      EXPECT_GE((candidates[a].center - candidates[b].center).norm(), kRadius);
    }
  }
  EXPECT_LE(scene.find(kRadius, 2).size(), 2U);
  EXPECT_TRUE(scene.find(kRadius, 0).empty());
}

// Also where the limit leaves room for no more than what lies outside.
TEST(CandidateSearch, FindsNothingOutsideTheBounds) {
  SearchScene scene(2);
  const Eigen::Vector3d inside = drawn::kMiddle + Eigen::Vector3d(0.15, 0.0, 0.0);
  const Eigen::Vector3d outside = drawn::kMiddle - Eigen::Vector3d(0.15, 0.0, 0.0);
  scene.show({Ball{inside, kRadius}, Ball{outside, kRadius}});
  ASSERT_TRUE(isFound(scene.find(), outside, 0.5 * kRadius));
  const WorldBox bounds{drawn::kMiddle - Eigen::Vector3d(0.0, 1.0, 1.0),
                        drawn::kMiddle + Eigen::Vector3d(1.0, 1.0, 1.0)};
  const auto candidates = scene.search().find(scene.observation(), true, 1, bounds);
  EXPECT_TRUE(isFound(candidates, inside, 0.5 * kRadius));
  for (const Candidate& candidate : scene.search().find(scene.observation(), true, 20, bounds)) {
    EXPECT_TRUE(bounds.contains(candidate.center)) << candidate.center.transpose();
  }
}

TEST(CandidateSearch, FindsNothingWithoutTheColorOrAnImage) {
  SearchScene scene(2);
  EXPECT_TRUE(scene.find().empty());
  EXPECT_TRUE(scene.find(0.0).empty());
  scene.show({});
  EXPECT_TRUE(scene.find().empty());
  EXPECT_TRUE(scene.find(0.0).empty());
}

// Eleven pixels large, to a pixel: a tenth of the distance.
TEST(CandidateSearch, WhatOneCameraSeesIsPlacedByItsSize) {
  SearchScene scene(2);
  const Eigen::Vector3d truth = drawn::placeNear(2, 0.1);
  scene.show(0, {Ball{truth, kRadius}}); // camera 1 has no image
  const auto candidates = scene.find();
  ASSERT_FALSE(candidates.empty());
  EXPECT_LT((candidates[0].center - truth).norm(), 0.15);
  const SphereProjector& projector = scene.observation().projector(0);
  const auto seen = projector.project(truth, kRadius);
  const auto found = projector.project(candidates[0].center, kRadius);
  ASSERT_TRUE(seen && found);
  EXPECT_LT((seen->center - found->center).norm(), 1.5);
}

TEST(CandidateSearch, AnUnknownRadiusComesFromTheImages) {
  SearchScene scene(2);
  for (const double radius : {0.025, 0.035, 0.06}) {
    const Eigen::Vector3d truth = drawn::placeNear(7, 0.1);
    scene.show({Ball{truth, radius}});
    const auto candidates = scene.find(0.0);
    ASSERT_FALSE(candidates.empty()) << radius;
    EXPECT_LT((candidates[0].center - truth).norm(), 0.4 * radius);
    EXPECT_NEAR(candidates[0].radius, radius, 0.2 * radius);
  }
}

// A ball three times as large may be the target right before one camera, out of the other's sight,
// but never one that two cameras agree on.
TEST(CandidateSearch, AThingOfAnotherSizeConvincesNoTwoCameras) {
  SearchScene scene(2);
  scene.show({Ball{drawn::kMiddle, 0.1}});
  for (const Candidate& candidate : scene.find()) {
    EXPECT_LT(candidate.logLikelihoodRatio, 1.2 * SphereEvidence::maxLogLikelihoodRatio());
  }
}

void expectSamePlaces(const std::vector<Candidate>& found, const std::vector<Candidate>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k].center, expected[k].center);
    EXPECT_EQ(found[k].radius, expected[k].radius);
    EXPECT_EQ(found[k].logLikelihoodRatio, expected[k].logLikelihoodRatio);
  }
}

TEST(SlicedSearch, FindsTheSameAtOnceWithoutABudget) {
  SearchScene scene(2);
  scene.show({Ball{drawn::kMiddle, kRadius},
              Ball{drawn::kMiddle + Eigen::Vector3d(0.15, 0.0, 0.0), kRadius}});
  SlicedSearch sliced = scene.inPieces();
  TimeBudget noLimit;
  ASSERT_TRUE(sliced.advance(scene.search(), noLimit, 10, false));
  expectSamePlaces(sliced.candidates(), scene.find());
}

// A budget of a femtosecond leaves time for nothing but what is urgent: one piece at a time. Each
// of two images has four bands of labels and its spots, then come the places: eleven.
TEST(SlicedSearch, FindsTheSameInPieces) {
  SearchScene scene(2);
  scene.show({Ball{drawn::kMiddle, kRadius}});
  SlicedSearch sliced = scene.inPieces();
  TimeBudget budget;
  budget.setLimit(1e-12);
  for (int piece = 1; piece <= 11; ++piece) {
    budget.beginIteration();
    EXPECT_EQ(sliced.advance(scene.search(), budget, 10, true), piece == 11) << piece;
  }
  expectSamePlaces(sliced.candidates(), scene.find());
  ASSERT_FALSE(sliced.candidates().empty());
}

TEST(SlicedSearch, WaitsForTime) {
  SearchScene scene(2);
  scene.show({Ball{drawn::kMiddle, kRadius}});
  SlicedSearch sliced = scene.inPieces();
  TimeBudget budget;
  budget.setLimit(1e-12);
  budget.beginIteration();
  EXPECT_FALSE(sliced.advance(scene.search(), budget, 10, false));
  EXPECT_TRUE(sliced.observation().labels(0).labeledArea().empty());
}

} // namespace
} // namespace dewpoint::tests
