// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/wait.h"
#include "ui/cameraview/camera_picture.h"
#include "ui/cameraview/camera_view.h"
#include "ui/style/target_colors.h"

#include <QImage>
#include <QTest>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <cmath>
#include <cstdlib>
#include <memory>

namespace dewpoint::tests {
namespace {

/// A snapshot in which the only camera shows one color all over; blue, green, red.
TrackSnapshotPtr showing(const cv::Scalar& color) {
  FrameSet set;
  set.frames = {
      std::make_shared<const Frame>(Frame{0, timeStamp(0.0), cv::Mat(60, 80, CV_8UC3, color)})};
  auto snapshot = std::make_shared<TrackSnapshot>();
  snapshot->frame = 0;
  snapshot->frames = std::make_shared<const FrameSet>(std::move(set));
  return snapshot;
}

QColor middleOf(CameraView& view) {
  const QImage picture = view.grab().toImage();
  return picture.pixelColor(picture.width() / 2, picture.height() / 2);
}

TEST(CameraPicture, AHiddenTargetIsNotDrawn) {
  TrackSnapshot bare = *showing({0, 0, 200});
  CameraRig rig(1);
  rig[0].intrinsics = {80, 60, 60.0, 60.0, 39.5, 29.5};
  bare.rig = std::make_shared<const CameraRig>(rig);
  bare.isTracked = true;
  TrackSnapshot with = bare;
  TargetSnapshot& target = with.targets.emplace_back();
  auto& sphere = std::get<SphereEstimate>(target.estimate);
  sphere.mean = {0.0, 0.0, 1.0};
  sphere.covariance = 1e-2 * Eigen::Matrix3d::Identity();
  sphere.particleCount = 1;
  sphere.isValid = true;
  target.status = TargetStatus::Held;
  target.particles = sphere.mean.transpose().array();
  target.weights.setOnes(1);
  TrackSnapshot hidden = with;
  hidden.targets[0].target.isShown = false;
  const auto picture = [](const TrackSnapshot& snapshot) {
    return cameraPicture(std::make_shared<const TrackSnapshot>(snapshot), 0, CameraViewOptions(),
                         {160, 120});
  };
  EXPECT_NE(picture(with), picture(bare));
  EXPECT_EQ(picture(hidden), picture(bare));
}

class ShownCameraView : public testing::Test, protected test::Waiting {
protected:
  static bool isDrawn(const CameraView& view) {
    return waitFor([&] { return view.isDrawn(); });
  }

  void SetUp() override {
    view_.resize(160, 120);
    view_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view_));
    view_.setSnapshot(showing({0, 0, 200}));
    ASSERT_TRUE(isDrawn(view_));
  }

  CameraView view_{0};
};

TEST_F(ShownCameraView, ShowsTheLastPictureUntilTheNextOneIsMade) {
  EXPECT_EQ(middleOf(view_), QColor(200, 0, 0));
  EXPECT_EQ(view_.imageSize(), QSize(80, 60));
  view_.setSnapshot(showing({200, 0, 0}));
  EXPECT_FALSE(view_.isDrawn());
  EXPECT_EQ(middleOf(view_), QColor(200, 0, 0)); // nobody waits for the pixels
  ASSERT_TRUE(isDrawn(view_));
  EXPECT_EQ(middleOf(view_), QColor(0, 0, 200));
}

TEST_F(ShownCameraView, OfManySnapshotsTheLastOneIsShownInTheEnd) {
  for (int green = 10; green <= 200; green += 10) {
    view_.setSnapshot(showing(cv::Scalar(0, green, 0)));
  }
  ASSERT_TRUE(isDrawn(view_));
  EXPECT_EQ(middleOf(view_), QColor(0, 200, 0));
}

TEST_F(ShownCameraView, AnotherSnapshotOfTheSameImageIsShownAtOnce) {
  const auto first = showing({0, 200, 0});
  view_.setSnapshot(first);
  ASSERT_TRUE(isDrawn(view_));
  view_.setSnapshot(std::make_shared<const TrackSnapshot>(*first)); // another iteration on it
  EXPECT_TRUE(view_.isDrawn());
}

TEST_F(ShownCameraView, AnotherSizeIsAnotherPicture) {
  view_.resize(320, 240);
  ASSERT_TRUE(isDrawn(view_));
  EXPECT_EQ(middleOf(view_), QColor(200, 0, 0));
}

TEST_F(ShownCameraView, WithoutImagesItIsDrawnAtOnce) {
  view_.setSnapshot(showing({0, 200, 0})); // not wanted any more
  view_.setSnapshot(nullptr);
  EXPECT_TRUE(view_.isDrawn());
  QTest::qWait(0);
  EXPECT_TRUE(view_.isDrawn());
  EXPECT_EQ(view_.state(), TrackingState::NoImages);
}

TEST_F(ShownCameraView, AnEarlierFrameIsNotShownAfterItWasHidden) {
  view_.hide();
  view_.setSnapshot(showing({200, 0, 0}));
  EXPECT_TRUE(view_.isDrawn()); // nothing is made while nobody sees it
  view_.show();
  EXPECT_FALSE(view_.isDrawn());
  EXPECT_NE(middleOf(view_), QColor(200, 0, 0));
  ASSERT_TRUE(isDrawn(view_));
  EXPECT_EQ(middleOf(view_), QColor(0, 0, 200));
  view_.setSnapshot(showing({0, 200, 0})); // is being made
  view_.hide();
  view_.setSnapshot(nullptr);
  view_.show();
  EXPECT_TRUE(view_.isDrawn());
  EXPECT_EQ(view_.state(), TrackingState::NoImages);
}

TEST_F(ShownCameraView, WhatIsStillOfTheNewestFrameIsThereAtOnce) {
  view_.hide();
  view_.show();
  EXPECT_TRUE(view_.isDrawn());
  EXPECT_EQ(middleOf(view_), QColor(200, 0, 0));
}

TEST_F(ShownCameraView, InAMinimizedWindowNothingIsMade) {
  view_.setWindowState(Qt::WindowMinimized);
  view_.setSnapshot(showing({200, 0, 0}));
  EXPECT_TRUE(view_.isDrawn());
  view_.setWindowState(Qt::WindowNoState);
  EXPECT_FALSE(view_.isDrawn());
  // The platform's own word of both states comes later.
  ASSERT_TRUE(waitFor([&] { return !view_.isMinimized() && view_.isDrawn(); }));
  EXPECT_EQ(middleOf(view_), QColor(0, 0, 200));
}

TEST_F(ShownCameraView, TheBestParticleIsMarkedOnlyWhenItIsWanted) {
  auto snapshot = std::make_shared<TrackSnapshot>(*showing({0, 200, 0}));
  Camera camera; // looks along +Z from the origin
  camera.intrinsics = {80, 60, 50.0, 50.0, 39.5, 29.5};
  snapshot->rig = std::make_shared<const CameraRig>(CameraRig{camera});
  SphereEstimate sphere;
  sphere.particleCount = 10;
  sphere.mean = {5.0, 0.0, 1.0}; // 250 px beside the image
  sphere.best = {0.0, 0.0, 1.0}; // in its middle
  snapshot->targets.emplace_back().estimate = sphere;
  view_.setSnapshot(snapshot);
  ASSERT_TRUE(isDrawn(view_));
  const QImage without = view_.grab().toImage();
  view_.setBestParticleShown(true);
  const QImage marked = view_.grab().toImage();
  EXPECT_NE(marked, without);
  // The triangle's tip is 8 px above the middle; the corners of the image are as before.
  EXPECT_NE(marked.copy(70, 48, 20, 20), without.copy(70, 48, 20, 20));
  EXPECT_EQ(marked.copy(0, 0, 40, 40), without.copy(0, 0, 40, 40));
  view_.setBestParticleShown(false);
  EXPECT_EQ(view_.grab().toImage(), without);
}

TEST_F(ShownCameraView, TheLikelihoodOfMotionIsDrawnOverTheWholeImage) {
  auto mapped = std::make_shared<TrackSnapshot>(*showing({200, 200, 200}));
  LikelihoodMap map;
  map.area = {0, 0, 80, 60};
  map.logLikelihood = cv::Mat(60, 80, CV_32FC1, cv::Scalar(0.0)); // D = 1 everywhere
  map.minLogLikelihood = std::log(0.2);
  mapped->motionMaps = {map};
  view_.setSnapshot(mapped);
  ASSERT_TRUE(isDrawn(view_));
  EXPECT_EQ(middleOf(view_), QColor(200, 200, 200));
  view_.setLikelihoodShown(true);
  ASSERT_TRUE(isDrawn(view_));
  const QColor likely = middleOf(view_); // light yellow over the gray
  EXPECT_GT(likely.red(), likely.blue() + 20);
  auto still = std::make_shared<TrackSnapshot>(*mapped);
  still->motionMaps[0].logLikelihood = cv::Mat(60, 80, CV_32FC1, cv::Scalar(map.minLogLikelihood));
  view_.setSnapshot(still);
  ASSERT_TRUE(isDrawn(view_));
  EXPECT_LT(middleOf(view_).lightness(), likely.lightness()); // dark blue
}

// The mask of a target (255 - 0) is a light tint; what has no mask stays as bright as it is.
TEST_F(ShownCameraView, AMaskTintsTheImage) {
  auto masked = std::make_shared<TrackSnapshot>(*showing({200, 200, 200}));
  masked->masks = {cv::Mat(60, 80, CV_8UC1, cv::Scalar(0))};
  view_.setSnapshot(masked);
  view_.setMaskShown(true);
  ASSERT_TRUE(isDrawn(view_));
  EXPECT_EQ(middleOf(view_), QColor(200, 200, 200));
  auto all = std::make_shared<TrackSnapshot>(*masked);
  all->masks = {cv::Mat(60, 80, CV_8UC1, cv::Scalar(255))};
  view_.setSnapshot(all);
  ASSERT_TRUE(isDrawn(view_));
  EXPECT_NE(middleOf(view_), QColor(200, 200, 200));
  EXPECT_GT(middleOf(view_).lightness(), 160);
  view_.setMaskShown(false);
  ASSERT_TRUE(isDrawn(view_));
  EXPECT_EQ(middleOf(view_), QColor(200, 200, 200));
}

// A pixel of another color, in the middle of what is seen, is a large square.
TEST_F(ShownCameraView, ZoomedPixelsAreSquares) {
  auto snapshot = std::make_shared<TrackSnapshot>(*showing({0, 200, 0}));
  cv::Mat image = snapshot->frames->frames[0]->image.clone();
  image.at<cv::Vec3b>(20, 30) = {0, 0, 200};
  FrameSet set;
  set.frames = {std::make_shared<const Frame>(Frame{0, timeStamp(0.0), image})};
  snapshot->frames = std::make_shared<const FrameSet>(std::move(set));
  view_.setSnapshot(snapshot);
  ASSERT_TRUE(isDrawn(view_));
  EXPECT_EQ(middleOf(view_), QColor(0, 200, 0)); // it was painted
  const QPointF at = view_.placement().positionOf({30.0, 20.0});
  view_.zoomBy(8.0, at); // twice as large where it is fitted: 16
  EXPECT_TRUE(view_.isZoomed());
  ASSERT_TRUE(isDrawn(view_));
  const QPointF middle = view_.placement().positionOf({30.0, 20.0});
  EXPECT_LE((middle - at).manhattanLength(), 1.01);
  const QImage picture = view_.grab().toImage();
  for (const QPointF& inside : {QPointF(-7, -7), QPointF(7, -7), QPointF(7, 7), QPointF(0, 0)}) {
    EXPECT_EQ(picture.pixelColor((middle + inside).toPoint()), QColor(200, 0, 0));
  }
  for (const QPointF& outside : {QPointF(-10, 0), QPointF(10, 0), QPointF(0, 10)}) {
    EXPECT_EQ(picture.pixelColor((middle + outside).toPoint()), QColor(0, 200, 0));
  }
  view_.setSnapshot(showing({200, 0, 0})); // another frame
  ASSERT_TRUE(isDrawn(view_));
  EXPECT_TRUE(view_.isZoomed());
  view_.fitImage();
  EXPECT_FALSE(view_.isZoomed());
  ASSERT_TRUE(isDrawn(view_));
  EXPECT_EQ(view_.placement().topLeft, QPointF(0.0, 0.0));
}

/// The same with a target that is held in the middle of the image, `spread` meters wide.
TrackSnapshotPtr holding(double spread) {
  auto snapshot = std::make_shared<TrackSnapshot>(*showing({0, 120, 0}));
  Camera camera; // looks along +Z from the origin
  camera.intrinsics = {80, 60, 50.0, 50.0, 39.5, 29.5};
  snapshot->rig = std::make_shared<const CameraRig>(CameraRig{camera});
  SphereEstimate sphere;
  sphere.particleCount = 3;
  sphere.mean = {0.0, 0.0, 1.0};
  sphere.covariance = spread * spread * Eigen::Matrix3d::Identity();
  TargetSnapshot& target = snapshot->targets.emplace_back();
  target.estimate = sphere;
  target.status = TargetStatus::Held;
  target.particles =
      (Eigen::ArrayXXd(3, 3) << 0.0, 0.0, 1.0, spread, 0.0, 1.0, 0.0, spread, 1.0).finished();
  target.weights = Eigen::ArrayXd::Constant(3, 1.0 / 3.0);
  return snapshot;
}

/// Pixels that have about this color.
int pixelsNear(const QImage& picture, const QColor& color) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const QColor there = picture.pixelColor(x, y);
      count += std::abs(there.red() - color.red()) + std::abs(there.green() - color.green()) +
                           std::abs(there.blue() - color.blue()) <
                       60
                   ? 1
                   : 0;
    }
  }
  return count;
}

TEST_F(ShownCameraView, EstimateAndMaskHaveTheLearnedColor) {
  auto snapshot = std::make_shared<TrackSnapshot>(*holding(0.02));
  snapshot->targets[0].particles.resize(0, 3);
  snapshot->targets[0].weights.resize(0);
  snapshot->targets[0].target.color = {200.0, 224.0, 0.4, 0.8, 0.3, 0.7}; // blue
  view_.setSnapshot(snapshot);
  ASSERT_TRUE(isDrawn(view_));
  const QColor color = targetColors(displayColorSources(*snapshot), DisplayBackground::Image)[0];
  EXPECT_GT(color.blue(), color.red() + 60);
  const int cross = pixelsNear(view_.grab().toImage(), color);
  EXPECT_GT(cross, 10);
  auto masked = std::make_shared<TrackSnapshot>(*snapshot);
  cv::Mat mask(60, 80, CV_8UC1, cv::Scalar(0));
  mask(cv::Rect(5, 5, 20, 20)).setTo(255); // far from the cross
  masked->masks = {mask};
  view_.setSnapshot(masked);
  view_.setMaskShown(true);
  ASSERT_TRUE(isDrawn(view_));
  EXPECT_GT(pixelsNear(view_.grab().toImage(), color), cross + 40); // its outline
}

TEST_F(ShownCameraView, ATightCloudIsEnlargedInACorner) {
  view_.resize(400, 300); // five widget units per pixel
  const auto changes = [this](const TrackSnapshotPtr& snapshot) {
    view_.setSnapshot(snapshot);
    EXPECT_TRUE(isDrawn(view_));
    view_.setMagnifierShown(false);
    const QImage without = view_.grab().toImage();
    view_.setMagnifierShown(true);
    return view_.grab().toImage() != without;
  };
  // Nine tenths of the weight reach as far as the outer two, 250 widget units for one meter.
  EXPECT_TRUE(changes(holding(0.004)));
  EXPECT_FALSE(changes(holding(0.05)));
  auto lost = std::make_shared<TrackSnapshot>(*holding(0.004));
  lost->targets[0].status = TargetStatus::Lost;
  EXPECT_FALSE(changes(lost));
  view_.setSnapshot(holding(0.004));
  ASSERT_TRUE(isDrawn(view_));
  view_.resize(160, 120); // no room
  ASSERT_TRUE(isDrawn(view_));
  EXPECT_FALSE(changes(holding(0.004)));
}

} // namespace
} // namespace dewpoint::tests
