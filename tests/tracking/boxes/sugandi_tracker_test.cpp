// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/boxes/sugandi_parameters.h"
#include "core/tracking/boxes/sugandi_tracker.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/tracker.h"
#include "tests/tracking/moving_patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace dewpoint::tests {
namespace {

std::unique_ptr<SugandiTracker> sugandi(int particles = 300) {
  ParameterValues parameters(sugandiParameters());
  EXPECT_TRUE(parameters.set("particles", particles));
  return std::make_unique<SugandiTracker>(parameters);
}

/// Root mean square distance of the centers, pixels, over `frames` frames.
double rmse(SugandiTracker& tracker, const MovingPatch& scene, std::uint64_t seed,
            int frames = 60) {
  ThreadTeam team(1);
  EXPECT_TRUE(tracker.start(scene.image(0), scene.box(0), seed));
  double sum = 0.0;
  for (int frame = 1; frame <= frames; ++frame) {
    const BoxEstimate estimate = tracker.step(scene.image(frame), team);
    sum += (estimate.box.center() - scene.box(frame).center()).squaredNorm();
  }
  return std::sqrt(sum / frames);
}

TEST(SugandiTracker, FollowsAPatch) {
  // The paper reports 2.28 px with 300 particles on its own clip.
  EXPECT_LT(rmse(*sugandi(), MovingPatch{}, 1), 2.28);
}

TEST(SugandiTracker, KeepsTheSizeOfTheBoxAndSaysHowSureItIs) {
  const MovingPatch scene;
  ThreadTeam team(1);
  const auto tracker = sugandi(100);
  ASSERT_TRUE(tracker->start(scene.image(0), scene.box(0), 3));
  const BoxEstimate estimate = tracker->step(scene.image(1), team);
  EXPECT_EQ(estimate.box.width, scene.side);
  EXPECT_EQ(estimate.box.height, scene.side);
  EXPECT_EQ(estimate.particleCount, 100);
  EXPECT_GT(estimate.similarity, 0.9);
  EXPECT_GT(estimate.spreadPixels, 0.0);
  EXPECT_GE(estimate.effectiveSampleSize, 1.0);
  EXPECT_LE(estimate.effectiveSampleSize, 100.0);
  EXPECT_TRUE(estimate.isVisible);
  Eigen::ArrayXXd centers;
  Eigen::ArrayXd weights;
  tracker->copyParticles(1000, centers, weights);
  EXPECT_EQ(centers.rows(), 100);
  EXPECT_EQ(centers.cols(), 2);
  EXPECT_NEAR(weights.sum(), 1.0, 1e-12); // of all particles
}

/// Without any color of the target in the image all weights are equal: the mean follows the motion
/// alone.
cv::Mat imageWithoutTheTarget(const MovingPatch& scene) {
  return {scene.size, CV_8UC3, cv::Scalar(0, 255, 0)};
}

TEST(SugandiTracker, StaysAtRestWhenItStartsAtRest) {
  // The mean's standard error is 10 px / sqrt(10000) = 0.1 px.
  const MovingPatch scene;
  ThreadTeam team(1);
  const auto tracker = sugandi(10000);
  ASSERT_TRUE(tracker->start(scene.image(0), scene.box(0), 5));
  const BoxEstimate estimate = tracker->step(imageWithoutTheTarget(scene), team);
  EXPECT_NEAR(estimate.box.center().x(), scene.box(0).center().x(), 0.5);
  EXPECT_NEAR(estimate.box.center().y(), scene.box(0).center().y(), 0.5);
  EXPECT_NEAR(estimate.spreadPixels, 10.0 * std::sqrt(2.0),
              0.5); // of a Gaussian with 10 px per axis
  EXPECT_NEAR(estimate.effectiveSampleSize, 10000.0, 1e-6);
}

TEST(SugandiTracker, MovesAsEquationFourSays) {
  const MovingPatch scene;
  ThreadTeam team(1);
  const auto tracker = sugandi(10000);
  const Eigen::Vector2d before = scene.box(0).center();
  ASSERT_TRUE(tracker->start(scene.image(0), scene.box(0), 5));
  // Frame 2 of the path: 10.8 px to the right and 12.2 px down, 90 sin(0.12) and
  // 60 sin(0.204).
  const BoxEstimate seen = tracker->step(scene.image(2), team);
  const Eigen::Vector2d velocity = seen.box.center() - before; // px per image
  ASSERT_GT(velocity.x(), 5.0);
  ASSERT_GT(velocity.y(), 5.0);
  // x_k+1 = 2 x_k - x_k-1 + w: the mean moves on by the same again. x + w would leave it where it
  // is. The standard error is that of twice the resampled spread (a few px) and of 10 px of noise,
  // over sqrt(10000): below 0.2 px.
  const Eigen::Vector2d expected = seen.box.center() + velocity;
  const BoxEstimate moved = tracker->step(imageWithoutTheTarget(scene), team);
  EXPECT_NEAR(moved.box.center().x(), expected.x(), 1.0);
  EXPECT_NEAR(moved.box.center().y(), expected.y(), 1.0);
  // Var(2 x_k + w) = 4 Var(x_k) + 100 px² per axis; resampling loses a little of Var(x_k).
  EXPECT_NEAR(moved.spreadPixels, std::sqrt(4.0 * seen.spreadPixels * seen.spreadPixels + 200.0),
              1.0);
}

TEST(SugandiTracker, SameSeedSameBitsForAnyNumberOfThreads) {
  const MovingPatch scene;
  ThreadTeam one(1);
  ThreadTeam three(3);
  const auto left = sugandi();
  const auto right = sugandi();
  ASSERT_TRUE(left->start(scene.image(0), scene.box(0), 11));
  ASSERT_TRUE(right->start(scene.image(0), scene.box(0), 11));
  for (int frame = 1; frame < 12; ++frame) {
    const BoxEstimate a = left->step(scene.image(frame), one);
    const BoxEstimate b = right->step(scene.image(frame), three);
    ASSERT_EQ(a.box, b.box) << "frame " << frame;
    ASSERT_EQ(a.similarity, b.similarity);
    ASSERT_EQ(a.effectiveSampleSize, b.effectiveSampleSize);
  }
}

TEST(SugandiTracker, ACopyGoesOnAlike) {
  const MovingPatch scene;
  ThreadTeam team(1);
  const auto tracker = sugandi();
  ASSERT_TRUE(tracker->start(scene.image(0), scene.box(0), 11));
  tracker->step(scene.image(1), team);
  const auto copy = std::make_unique<SugandiTracker>(*tracker);
  const ImageBox next = tracker->step(scene.image(2), team).box;
  tracker->step(scene.image(3), team);
  EXPECT_EQ(copy->step(scene.image(2), team).box, next);
}

TEST(BoxFilter, NamesWhatIsWrong) {
  const MovingPatch scene;
  const cv::Mat image = scene.image(0);
  const auto tracker = sugandi();
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  for (const ImageBox& box : {ImageBox{10, 10, 1, 20}, ImageBox{-40, 10, 30, 30},
                              ImageBox{nothing, 10, 30, 30}, ImageBox{0, 0, 400, 20}}) {
    const auto started = tracker->start(image, box, 1);
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().field, "box");
  }
  EXPECT_EQ(tracker->start(cv::Mat(), {0, 0, 9, 9}, 1).error().field, "image");
  const ParameterValues others(methodParameters("barrera"));
  EXPECT_EQ(makeTracker("sugandi", others, {}, {}).error().code, ErrorCode::MissingKey);
}

TEST(BoxFilter, EveryMethodDeclaresItsParameters) {
  for (const std::string& method : methodNames(TargetSource::Box)) {
    EXPECT_FALSE(methodParameters(method).empty()) << method;
    EXPECT_FALSE(methodSummary(method).empty()) << method;
    for (const ParameterDeclaration& declaration : methodParameters(method)) {
      EXPECT_GE(declaration.defaultValue, declaration.minimum) << declaration.key;
      EXPECT_LE(declaration.defaultValue, declaration.maximum) << declaration.key;
      EXPECT_FALSE(declaration.description.empty()) << declaration.key;
    }
  }
}

TEST(BoxFilter, GrowsABoxFromAClick) {
  MovingPatch scene;
  cv::Mat image(240, 320, CV_8UC3, cv::Scalar(120, 120, 120));
  cv::rectangle(image, {100, 60, 40, 25}, cv::Scalar(30, 30, 220), cv::FILLED);
  const auto box = boxFromClick(image, 120.0, 70.0);
  ASSERT_TRUE(box);
  EXPECT_GT(intersectionOverUnion(*box, {100, 60, 40, 25}),
            0.85); // the outline to a pixel on each side
  EXPECT_EQ(boxFromClick(image, 320.0, 70.0).error().field, "pixel");
}

} // namespace
} // namespace dewpoint::tests
