// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/clicks/counterpart_search.h"
#include "tests/setup/clicks/painted_rig.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace dewpoint::tests {
namespace {

using setup::CounterpartLimits;
using setup::Counterparts;
using setup::findCounterparts;

const color::BgrColor kGreen{60, 160, 40};

bool holds(const cv::Mat& mask, const Eigen::Vector2d& pixel) {
  return !mask.empty() && mask.at<std::uint8_t>(static_cast<int>(std::lround(pixel.y())),
                                                static_cast<int>(std::lround(pixel.x()))) != 0;
}

TEST(CounterpartSearch, FindsTheBallInTheOtherCameras) {
  PaintedRig scene(3);
  scene.paintInAll(kBall, kRadius, kRed);
  const Counterparts counterparts =
      findCounterparts(scene.rig, scene.images, scene.clickOn(0, kBall, kRadius));
  ASSERT_EQ(counterparts.samples.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const color::ColorSample& sample = counterparts.samples[i];
    EXPECT_EQ(sample.camera, static_cast<int>(i) + 1);
    EXPECT_TRUE(sample.isFoundByGeometry && !sample.isExcluded);
    EXPECT_TRUE(scene.isOn(sample, kBall, kRadius));
    EXPECT_FALSE(counterparts.outlines[i].empty());
  }
}

// A warm camera: red is 12 % brighter, blue 12 % darker, and all of it a quarter darker. A range
// that fits the click takes none of it.
TEST(CounterpartSearch, FindsItInACameraWithOtherWhiteBalanceAndExposure) {
  PaintedRig scene(2);
  scene.paint(0, kBall, kRadius, kRed);
  scene.paint(1, kBall, kRadius, {26, 30, 168});
  const Counterparts counterparts =
      findCounterparts(scene.rig, scene.images, scene.clickOn(0, kBall, kRadius));
  ASSERT_EQ(counterparts.samples.size(), 1U);
  EXPECT_TRUE(scene.isOn(counterparts.samples[0], kBall, kRadius));
}

// The same color lies a meter beside the ray, where the click's ray does not pass: 150 px of it.
TEST(CounterpartSearch, DoesNotTakeTheSameColorBesideTheRay) {
  PaintedRig scene(2);
  scene.paint(0, kBall, kRadius, kRed);
  scene.paint(1, kBall + Eigen::Vector3d(0.0, 0.0, 0.5), kRadius, kRed);
  const Counterparts counterparts =
      findCounterparts(scene.rig, scene.images, scene.clickOn(0, kBall, kRadius));
  EXPECT_TRUE(counterparts.samples.empty());
}

TEST(CounterpartSearch, DoesNotTakeAnotherColorOnTheRay) {
  PaintedRig scene(2);
  scene.paint(0, kBall, kRadius, kRed);
  scene.paint(1, kBall, kRadius, kGreen);
  EXPECT_TRUE(
      findCounterparts(scene.rig, scene.images, scene.clickOn(0, kBall, kRadius)).samples.empty());
}

// Two balls alike on the ray of the click, one behind the other in its camera: beside each other in
// the second camera, which cannot tell; neither is background there.
TEST(CounterpartSearch, LeavesOpenWhichOfTwoAlikeItIs) {
  PaintedRig scene(2);
  const Eigen::Vector3d sight = (kBall - scene.rig[0].center()).normalized();
  const Eigen::Vector3d behind = kBall + 0.3 * sight;
  scene.paint(0, kBall, kRadius, kRed);
  scene.paint(1, kBall, kRadius, kRed);
  scene.paint(1, behind, kRadius * 1.15, kRed); // as large as it would have to be there
  const Counterparts counterparts =
      findCounterparts(scene.rig, scene.images, scene.clickOn(0, kBall, kRadius));
  EXPECT_TRUE(counterparts.samples.empty());
  EXPECT_TRUE(holds(counterparts.undecidedMasks[1], scene.discOf(1, kBall, kRadius).center));
  EXPECT_TRUE(holds(counterparts.undecidedMasks[1], scene.discOf(1, behind, kRadius).center));
}

// The same, but a third camera shows only the nearer one.
TEST(CounterpartSearch, DecidesByAThirdCamera) {
  PaintedRig scene(3);
  const Eigen::Vector3d sight = (kBall - scene.rig[0].center()).normalized();
  scene.paintInAll(kBall, kRadius, kRed);
  scene.paint(1, kBall + 0.3 * sight, kRadius * 1.15, kRed);
  const Counterparts counterparts =
      findCounterparts(scene.rig, scene.images, scene.clickOn(0, kBall, kRadius));
  ASSERT_EQ(counterparts.samples.size(), 2U);
  EXPECT_TRUE(scene.isOn(counterparts.samples[0], kBall, kRadius));
}

// And so does a volume that only the nearer one lies in, if what lies outside is not so much that
// its color is common.
TEST(CounterpartSearch, DecidesByTheVolume) {
  constexpr double kSmall = 0.05;
  PaintedRig scene(2);
  const Eigen::Vector3d sight = (kBall - scene.rig[0].center()).normalized();
  scene.paint(0, kBall, kSmall, kRed);
  scene.paint(1, kBall, kSmall, kRed);
  scene.paint(1, kBall + 0.6 * sight, kSmall * 1.3, kRed);
  const ColorSample click = scene.clickOn(0, kBall, kSmall);
  EXPECT_TRUE(findCounterparts(scene.rig, scene.images, click).samples.empty());
  CounterpartLimits limits;
  limits.volume =
      WorldBox{kBall - Eigen::Vector3d::Constant(0.1), kBall + Eigen::Vector3d::Constant(0.1)};
  const Counterparts counterparts = findCounterparts(scene.rig, scene.images, click, limits);
  ASSERT_EQ(counterparts.samples.size(), 1U);
  EXPECT_TRUE(scene.isOn(counterparts.samples[0], kBall, kSmall));
}

// The discs are 14.9 and 14.0 px in radius; regions lack some of their rims.
TEST(CounterpartSearch, ShowsTheRadius) {
  PaintedRig scene(3);
  scene.paintInAll(kBall, kRadius, kRed);
  const Counterparts counterparts =
      findCounterparts(scene.rig, scene.images, scene.clickOn(0, kBall, kRadius));
  ASSERT_TRUE(counterparts.radius);
  EXPECT_NEAR(*counterparts.radius, kRadius, 0.1 * kRadius);
}

// Of a quarter of the radius the logarithm, 1.4, is four standard deviations: nothing fits it, and
// it is said what does.
TEST(CounterpartSearch, SearchesForAnyRadiusWhereTheKnownOneFitsNothing) {
  PaintedRig scene(2);
  scene.paintInAll(kBall, kRadius, kRed);
  CounterpartLimits limits;
  limits.radius = 0.25 * kRadius;
  const Counterparts counterparts =
      findCounterparts(scene.rig, scene.images, scene.clickOn(0, kBall, kRadius), limits);
  ASSERT_EQ(counterparts.samples.size(), 1U);
  EXPECT_NEAR(counterparts.radius.value(), kRadius, 0.1 * kRadius);
}

TEST(CounterpartSearch, DoesNotTakeWhatIsExcluded) {
  PaintedRig scene(2);
  scene.paintInAll(kBall, kRadius, kRed);
  CounterpartLimits limits;
  limits.excludedSamples = {scene.clickOn(1, kBall, kRadius)};
  limits.excludedSamples[0].isExcluded = true;
  const Counterparts counterparts =
      findCounterparts(scene.rig, scene.images, scene.clickOn(0, kBall, kRadius), limits);
  EXPECT_TRUE(counterparts.samples.empty());
}

TEST(CounterpartSearch, FindsNothingWithoutCalibrationOrImage) {
  PaintedRig scene(3);
  scene.paintInAll(kBall, kRadius, kRed);
  const color::ColorSample click = scene.clickOn(0, kBall, kRadius);
  scene.rig[1].intrinsics.focalX = scene.rig[1].intrinsics.focalY = 0.0;
  scene.images[2].release();
  const Counterparts counterparts = findCounterparts(scene.rig, scene.images, click);
  EXPECT_TRUE(counterparts.samples.empty());
  EXPECT_EQ(counterparts.undecidedMasks.size(), 3U);
}

} // namespace
} // namespace dewpoint::tests
