// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/boxes/color_peaks.h"
#include "core/tracking/boxes/histogram_parameters.h"
#include "core/tracking/boxes/histogram_tracker.h"
#include "core/tracking/catalog/method_catalog.h"
#include "tests/tracking/moving_patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace dewpoint::tests {
namespace {

std::unique_ptr<HistogramTracker> histogram() {
  return std::make_unique<HistogramTracker>(ParameterValues(histogramParameters()));
}

TEST(HistogramTracker, IsTheDefault) {
  EXPECT_EQ(methodNames(TargetSource::Box).front(), "histogram");
}

TEST(HistogramTracker, FollowsAPatch) {
  const MovingPatch scene;
  ThreadTeam team(1);
  const auto tracker = histogram();
  ASSERT_TRUE(tracker->start(scene.image(0), scene.box(0), 1));
  double least = 1.0;
  for (int frame = 1; frame <= 60; ++frame) {
    const BoxEstimate estimate = tracker->step(scene.image(frame), team);
    EXPECT_TRUE(estimate.isVisible) << frame;
    least = std::min(least, intersectionOverUnion(estimate.box, scene.box(frame)));
  }
  EXPECT_GT(least, 0.7); // a patch of clear colors: 2 px off in both directions are 0.77
}

TEST(HistogramTracker, FollowsFromASloppyBox) {
  const MovingPatch scene;
  ThreadTeam team(1);
  for (const double scale : {0.8, 1.2, 1.4}) {
    for (const double shift : {-0.15, 0.15}) {
      const auto tracker = histogram();
      const ImageBox truth = scene.box(0);
      const ImageBox drawn =
          ImageBox::around(truth.center() + shift * Eigen::Vector2d(scene.side, scene.side),
                           scale * scene.side, scale * scene.side);
      ASSERT_TRUE(tracker->start(scene.image(0), drawn, 1));
      double farthest = 0.0;
      for (int frame = 1; frame <= 60; ++frame) {
        const BoxEstimate estimate = tracker->step(scene.image(frame), team);
        farthest = std::max(farthest, (estimate.box.center() - scene.box(frame).center()).norm());
      }
      EXPECT_LT(farthest, 0.5 * scene.side) << scale << ' ' << shift; // 0.21 as drawn
    }
  }
}

TEST(HistogramTracker, KeepsTheMarginOfTheDrawnBox) {
  const MovingPatch scene;
  ThreadTeam team(1);
  const auto tracker = histogram();
  const ImageBox truth = scene.box(0);
  const double drawn = 1.4 * scene.side;
  ASSERT_TRUE(tracker->start(scene.image(0), ImageBox::around(truth.center(), drawn, drawn), 1));
  BoxEstimate estimate;
  for (int frame = 1; frame <= 30; ++frame) {
    estimate = tracker->step(scene.image(frame), team);
  }
  EXPECT_NEAR(estimate.box.width, drawn, 0.15 * drawn);
  EXPECT_NEAR(estimate.box.height, drawn, 0.15 * drawn);
}

/// What is said of a box must fall when the target is gone, whatever is learned meanwhile.
TEST(HistogramTracker, DoesNotCallTheGroundTheTarget) {
  const MovingPatch scene;
  ThreadTeam team(1);
  auto parameters = ParameterValues(histogramParameters());
  ASSERT_TRUE(parameters.set("hidden_below", 0.0)); // it takes whatever it finds for the target
  for (const double scale : {1.0, 1.4}) {
    HistogramTracker tracker(parameters);
    const double drawn = scale * scene.side;
    ASSERT_TRUE(
        tracker.start(scene.image(0), ImageBox::around(scene.box(0).center(), drawn, drawn), 1));
    for (int frame = 1; frame <= 10; ++frame) {
      EXPECT_GT(tracker.step(scene.image(frame), team).similarity, 0.8) << frame;
    }
    for (int frame = 11; frame <= 80; ++frame) {
      EXPECT_LT(tracker.step(scene.image(frame, false), team).similarity, 0.2) << frame;
    }
  }
}

TEST(HistogramTracker, HoldsAHiddenTargetAndFindsItAgain) {
  const MovingPatch scene;
  ThreadTeam team(1);
  const auto tracker = histogram();
  ASSERT_TRUE(tracker->start(scene.image(0), scene.box(0), 1));
  ImageBox last;
  for (int frame = 1; frame <= 15; ++frame) {
    last = tracker->step(scene.image(frame), team).box;
  }
  for (int frame = 16; frame <= 25; ++frame) {
    const BoxEstimate held = tracker->step(scene.image(frame, false), team);
    EXPECT_FALSE(held.isVisible) << frame;
    EXPECT_EQ(held.box, last) << frame;
  }
  BoxEstimate found; // it has moved on by more than its size; a second is enough to find it
  for (int frame = 26; frame <= 50; ++frame) {
    found = tracker->step(scene.image(frame), team);
  }
  EXPECT_TRUE(found.isVisible);
  EXPECT_GT(intersectionOverUnion(found.box, scene.box(50)), 0.7);
}

TEST(HistogramTracker, FollowsTheScale) {
  MovingPatch scene;
  scene.side = 40.0;
  ThreadTeam team(1);
  const auto tracker = histogram();
  ASSERT_TRUE(tracker->start(scene.image(0), scene.box(0), 1));
  BoxEstimate estimate;
  for (int frame = 1; frame <= 60; ++frame) {
    scene.side = 40.0 + 0.4 * frame;
    estimate = tracker->step(scene.image(frame), team);
  }
  EXPECT_NEAR(estimate.box.width, scene.side, 0.15 * scene.side);
}

TEST(HistogramTracker, LooksAtLargeTargetsInASmallerImage) {
  MovingPatch scene;
  scene.side = 100.0; // more than 48 x 48 pixels
  ThreadTeam team(1);
  const auto tracker = histogram();
  ASSERT_TRUE(tracker->start(scene.image(0), scene.box(0), 1));
  BoxEstimate estimate;
  for (int frame = 1; frame <= 20; ++frame) {
    estimate = tracker->step(scene.image(frame), team);
  }
  EXPECT_GT(intersectionOverUnion(estimate.box, scene.box(20)), 0.7);
}

TEST(HistogramTracker, SameSeedSameBitsForAnyNumberOfThreadsAndForACopy) {
  const MovingPatch scene;
  ThreadTeam one(1);
  ThreadTeam three(3);
  const auto left = histogram();
  const auto right = histogram();
  ASSERT_TRUE(left->start(scene.image(0), scene.box(0), 11));
  ASSERT_TRUE(right->start(scene.image(0), scene.box(0), 11));
  for (int frame = 1; frame < 12; ++frame) {
    const auto copy = std::make_unique<HistogramTracker>(*left);
    const BoxEstimate a = left->step(scene.image(frame), one);
    const BoxEstimate b = right->step(scene.image(frame), three);
    ASSERT_EQ(a.box, b.box) << "frame " << frame;
    ASSERT_EQ(a.similarity, b.similarity);
    ASSERT_EQ(copy->step(scene.image(frame), one).box, a.box);
  }
}

TEST(HistogramTracker, SurvivesABoxAtTheBorderAndAnEmptyImage) {
  const MovingPatch scene;
  ThreadTeam team(1);
  const auto tracker = histogram();
  ASSERT_TRUE(tracker->start(scene.image(0), {-10.0, -10.0, 30.0, 30.0}, 1));
  for (int frame = 1; frame < 200; ++frame) {
    const BoxEstimate estimate = tracker->step(cv::Mat::zeros(scene.size, CV_8UC3), team);
    ASSERT_TRUE(std::isfinite(estimate.box.x) && std::isfinite(estimate.spreadPixels)) << frame;
  }
}

TEST(TargetMap, SumsTheSharesOfABox) {
  cv::Mat image(60, 80, CV_8UC3, cv::Scalar(0, 0, 0));
  cv::rectangle(image, {20, 10, 12, 18}, cv::Scalar(0, 0, 255), cv::FILLED);
  TargetColors colors;
  colors.learn(image, {20, 10, 12, 18});
  TargetMap map;
  map.build(image, {{0, 0}, image.size()}, colors);
  // Red is in the box alone: its share is 1 but for the rounding to a 256th; black is around only.
  EXPECT_NEAR(map.sum({20, 10, 12, 18}), 12.0 * 18.0, 1.0);
  EXPECT_NEAR(map.sum({40, 30, 12, 18}), 0.0, 1.0);
  EXPECT_NEAR(map.sum({14, 10, 12, 18}), 6.0 * 18.0, 1.0);   // half of it
  EXPECT_NEAR(map.sum({14.5, 10, 12, 18}), 6.5 * 18.0, 1.0); // by area
  EXPECT_EQ(map.sum({200, 200, 12, 18}), 0.0);
  const auto peaks = findColorPeaks(map, 12.0, 18.0, 3, 50.0);
  ASSERT_FALSE(peaks.empty());
  EXPECT_LT((peaks.front() - Eigen::Vector2d(26.0, 19.0)).norm(), 4.3); // on a grid of 3 px
}

} // namespace
} // namespace dewpoint::tests
