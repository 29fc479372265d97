// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/clicks/click_learning.h"
#include "core/setup/clicks/counterpart_search.h"
#include "core/setup/clicks/marked_part.h"
#include "tests/setup/clicks/painted_rig.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

const color::BgrColor kSkin{90, 120, 190};
const Eigen::Vector3d kHand(0.1, -0.1, 0.2);
const Eigen::Vector3d kElbow(0.1, -0.1, -0.3);
constexpr double kHandRadius = 0.09;
constexpr double kArmRadius = 0.06;

/// A hand at the upper end of an arm.
PaintedRig paintedArm(std::size_t cameras) {
  PaintedRig scene(cameras);
  constexpr int kPieces = 25;
  for (int i = 0; i <= kPieces; ++i) {
    scene.paintInAll(kElbow + (kHand - kElbow) * i / kPieces, kArmRadius, kSkin);
  }
  scene.paintInAll(kHand, kHandRadius, kSkin);
  // One color all over, without the painted shading of each piece.
  for (cv::Mat& image : scene.images) {
    cv::Mat wall;
    cv::inRange(image, cv::Scalar(120, 120, 120), cv::Scalar(120, 120, 120), wall);
    image.setTo(cv::Scalar(kSkin[0], kSkin[1], kSkin[2]), ~wall);
  }
  return scene;
}

color::ColorSample boxOn(const PaintedRig& scene, std::size_t camera, const Eigen::Vector3d& center,
                         double radius) {
  const SphereImage disc = scene.discOf(camera, center, radius);
  color::ColorSample box;
  box.camera = static_cast<int>(camera);
  box.x = std::round(disc.center.x() - disc.radius);
  box.y = std::round(disc.center.y() - disc.radius);
  box.width = box.height = std::round(2.0 * disc.radius);
  return color::takeSample(scene.images[camera], box).value();
}

TEST(MarkedPart, IsWhatABoxHoldsOfSomethingLarger) {
  const PaintedRig scene = paintedArm(1);
  const SphereImage hand = scene.discOf(0, kHand, kHandRadius);
  const auto part = setup::partInBox(scene.images[0], boxOn(scene, 0, kHand, 1.2 * kHandRadius));
  ASSERT_TRUE(part);
  EXPECT_LT((part->center - hand.center).norm(), 2.0);
  EXPECT_NEAR(part->radiusPx, hand.radius, 2.0);
  EXPECT_FALSE(part->wholeObject.isBox());
  EXPECT_GT(part->wholeObject.areaPx, 1.5 * 3.14 * hand.radius * hand.radius);
  // A box around all of it, and no box.
  const Eigen::Vector3d middle = 0.5 * (kHand + kElbow);
  EXPECT_FALSE(setup::partInBox(scene.images[0], boxOn(scene, 0, middle, 0.4)));
  EXPECT_FALSE(setup::partInBox(scene.images[0], scene.clickOn(0, kHand, kHandRadius)));
}

TEST(MarkedPart, IsWhatWasClickedOfSomethingLargerThanTheRadiusKnown) {
  const PaintedRig scene = paintedArm(1);
  const SphereImage hand = scene.discOf(0, kHand, kHandRadius);
  color::ColorSample click = scene.clickOn(0, kHand, kHandRadius);
  click.x += 6.0;
  const auto part = setup::partAtClick(scene.images[0], click, hand.radius);
  ASSERT_TRUE(part);
  EXPECT_LT((part->center - hand.center).norm(), 4.0);
  // Something of about that size, and a box.
  EXPECT_FALSE(setup::partAtClick(scene.images[0], click, 2.0 * hand.radius));
  EXPECT_FALSE(
      setup::partAtClick(scene.images[0], boxOn(scene, 0, kHand, kHandRadius), hand.radius));
}

TEST(MarkedPart, LiesOnItsRayWhereTheOtherCameraShowsTheThing) {
  const PaintedRig scene = paintedArm(2);
  const auto mark = setup::partInBox(scene.images[0], boxOn(scene, 0, kHand, 1.2 * kHandRadius));
  ASSERT_TRUE(mark);
  const auto found = setup::findCounterparts(scene.rig, scene.images, mark->wholeObject).samples;
  ASSERT_EQ(found.size(), 1U);
  const auto part = setup::locatePart(scene.rig, scene.images, {*mark}, found);
  ASSERT_TRUE(part);
  EXPECT_LT((part->position.mean - kHand).norm(), 0.02);
  EXPECT_NEAR(part->radius, kHandRadius, 0.01);
  // Its depth is known to the thickness of the thing: uniform, 0.18 m wide.
  EXPECT_NEAR(std::sqrt(part->position.covariance(1, 1)), 0.18 / std::sqrt(12.0), 0.02);
  EXPECT_FALSE(setup::locatePart(scene.rig, scene.images, {*mark}, {}));
}

TEST(MarkedPart, LiesWhereTheRaysOfSeveralMarksMeet) {
  const PaintedRig scene = paintedArm(3);
  std::vector<setup::PartMark> marks;
  for (std::size_t camera = 0; camera < 3; ++camera) {
    marks.push_back(
        setup::partInBox(scene.images[camera], boxOn(scene, camera, kHand, 1.2 * kHandRadius))
            .value());
  }
  const auto part = setup::locatePart(scene.rig, scene.images, marks, {});
  ASSERT_TRUE(part);
  EXPECT_EQ(part->clicks.size(), 3U);
  EXPECT_LT((part->position.mean - kHand).norm(), 0.01);
  EXPECT_LT(part->position.covariance.trace(), 3 * 0.04 * 0.04);
}

// One box on the hand: its position is a correction, its radius the target's; a second box in the
// other camera makes the position exact.
TEST(MarkedPart, BecomesTheTarget) {
  const PaintedRig scene = paintedArm(2);
  Project project;
  for (const Camera& camera : scene.rig) {
    project.cameras.emplace_back().camera = camera;
  }
  project.targets.emplace_back();
  std::vector<color::ColorSample> boxes{boxOn(scene, 0, kHand, 1.2 * kHandRadius)};
  const auto result = setup::learnFromClicks(project, 0, {scene.images, {}, 0}, boxes);
  ASSERT_TRUE(result && result->part);
  EXPECT_EQ(result->radius, result->part->radius);
  setup::applyLearningResult(*result, 0, project);
  EXPECT_NEAR(project.targets[0].radius, kHandRadius, 0.01);
  ASSERT_EQ(project.corrections.size(), 1U);
  EXPECT_LT((project.corrections[0].position - kHand).norm(), 0.02);

  boxes.push_back(boxOn(scene, 1, kHand, 1.2 * kHandRadius));
  const auto both = setup::learnFromClicks(project, 0, {scene.images, {}, 0}, boxes);
  ASSERT_TRUE(both && both->part);
  project.targets[0].radius = 0.08; // given by hand: it stays
  setup::applyLearningResult(*both, 0, project);
  EXPECT_EQ(project.targets[0].radius, 0.08);
  ASSERT_EQ(project.corrections.size(), 1U);
  EXPECT_EQ(project.corrections[0].clicks.size(), 2U);

  // A box on the wall is no part of a thing.
  const Eigen::Vector3d beside(-0.4, 0.0, 0.2);
  const auto wall =
      setup::learnFromClicks(project, 0, {scene.images, {}, 0}, {boxOn(scene, 0, beside, 0.1)});
  ASSERT_TRUE(wall);
  EXPECT_FALSE(wall->part);

  // A click on all of it, with no radius known, is on no part.
  project.targets[0].radius = 0.0;
  const auto whole = setup::learnFromClicks(project, 0, {scene.images, {}, 0},
                                            {scene.clickOn(0, kHand, kHandRadius)});
  ASSERT_TRUE(whole);
  EXPECT_FALSE(whole->part);
}

} // namespace
} // namespace dewpoint::tests
