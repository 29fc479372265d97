// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_classifier.h"
#include "core/setup/clicks/click_learning.h"
#include "tests/setup/clicks/painted_rig.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

using setup::learnFromClicks;

const color::BgrColor kWarmRed{26, 60, 168}; // the same ball in a warm, dark camera

PaintedRig ballInTwoColors() {
  PaintedRig scene(2);
  scene.paint(0, kBall, kRadius, kRed);
  scene.paint(1, kBall, kRadius, kWarmRed);
  return scene;
}

bool matches(const color::ColorRange& range, const color::BgrColor& bgr) {
  return color::ColorClassifier(range).matches(bgr[0], bgr[1], bgr[2]);
}

TEST(ClickLearningResult, TakesInWhatTheOtherCameraShows) {
  const PaintedRig scene = ballInTwoColors();
  const auto result =
      learnFromClicks(scene.rig, {scene.images, {}, 7}, {scene.clickOn(0, kBall, kRadius)});
  // The click is of frame 0, the images are of frame 7: nothing is searched for.
  ASSERT_TRUE(result);
  EXPECT_EQ(result->samples.size(), 1U);

  color::ColorSample click = scene.clickOn(0, kBall, kRadius);
  click.frame = 7;
  const auto now = learnFromClicks(scene.rig, {scene.images, {}, 7}, {click});
  ASSERT_TRUE(now);
  ASSERT_EQ(now->samples.size(), 2U);
  EXPECT_EQ(now->samples[0], click);
  EXPECT_TRUE(now->samples[1].isFoundByGeometry);
  EXPECT_EQ(now->samples[1].frame, 7);
  EXPECT_EQ(now->outlines.size(), 1U);
  EXPECT_TRUE(matches(now->color.range, kRed));
  EXPECT_TRUE(matches(now->color.range, kWarmRed));
  EXPECT_FALSE(matches(now->color.range, {120, 120, 120}));
}

TEST(ClickLearningResult, DoesNotSearchWhereTheTargetWasClicked) {
  const PaintedRig scene = ballInTwoColors();
  const std::vector<color::ColorSample> clicks{scene.clickOn(0, kBall, kRadius),
                                               scene.clickOn(1, kBall, kRadius)};
  const auto result = learnFromClicks(scene.rig, {scene.images, {}, 0}, clicks);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->samples, clicks);
}

// Two balls that touch, of one thing: each color is found in the other camera by itself.
TEST(ClickLearningResult, FindsEachColorOfATargetInTheOtherCamera) {
  const color::BgrColor blue{200, 80, 30};
  const Eigen::Vector3d other = kBall + Eigen::Vector3d(0.0, 0.0, 2.0 * kRadius);
  PaintedRig scene(2);
  for (int camera = 0; camera < 2; ++camera) {
    scene.paint(camera, kBall, kRadius, kRed);
    scene.paint(camera, other, kRadius, blue);
  }
  const auto result =
      learnFromClicks(scene.rig, {scene.images, {}, 0},
                      {scene.clickOn(0, kBall, kRadius), scene.clickOn(0, other, kRadius)});
  ASSERT_TRUE(result);
  ASSERT_EQ(result->samples.size(), 4U);
  EXPECT_EQ(result->samples[2].camera, 1);
  EXPECT_EQ(result->samples[3].camera, 1);
  EXPECT_EQ(result->outlines.size(), 2U);
  for (const color::BgrColor& bgr : {kRed, blue}) {
    EXPECT_TRUE(color::ColorClassifier(result->color.ranges()).matches(bgr[0], bgr[1], bgr[2]));
  }
  ASSERT_TRUE(result->radius);
  EXPECT_NEAR(*result->radius, std::sqrt(2.0) * kRadius, 0.2 * kRadius) << "of both together";
  ASSERT_EQ(result->centers.size(), 2U);
  for (const PointClick& center : result->centers) {
    const auto camera = static_cast<std::size_t>(center.camera);
    const Eigen::Vector2d middle = 0.5 * (scene.discOf(camera, kBall, kRadius).center +
                                          scene.discOf(camera, other, kRadius).center);
    EXPECT_LT((center.pixel - middle).norm(), 3.0) << camera;
  }
  Project project;
  project.targets.resize(1);
  applyLearningResult(*result, 0, project);
  EXPECT_EQ(project.targets[0].colors(), result->color.ranges());
}

TEST(ClickLearningResult, KeepsWhatWasFoundInOtherFramesWithTheirClicks) {
  const PaintedRig scene = ballInTwoColors();
  const auto first =
      learnFromClicks(scene.rig, {scene.images, {}, 0}, {scene.clickOn(0, kBall, kRadius)});
  ASSERT_TRUE(first);
  color::ColorSample later = scene.clickOn(0, kBall, kRadius);
  later.frame = 5;
  std::vector<color::ColorSample> samples = first->samples;
  samples.push_back(later);
  const auto both = learnFromClicks(scene.rig, {scene.images, {}, 5}, samples);
  ASSERT_TRUE(both);
  ASSERT_EQ(both->samples.size(), 4U); // two clicks, and one found of each
  EXPECT_EQ(both->samples[2].frame, 0);
  EXPECT_EQ(both->samples[3].frame, 5);

  // Without the first click its companion goes too.
  const auto rest =
      learnFromClicks(scene.rig, {scene.images, {}, 5}, setup::withoutSample(both->samples, 0));
  ASSERT_TRUE(rest);
  ASSERT_EQ(rest->samples.size(), 2U);
  EXPECT_EQ(rest->samples[0].frame, 5);
  EXPECT_EQ(rest->samples[1].frame, 5);
}

TEST(ClickLearningResult, ExcludesWhatWasFoundAndTakenAway) {
  const PaintedRig scene = ballInTwoColors();
  const auto result =
      learnFromClicks(scene.rig, {scene.images, {}, 0}, {scene.clickOn(0, kBall, kRadius)});
  ASSERT_TRUE(result);
  const auto without = setup::withoutSample(result->samples, 1);
  ASSERT_EQ(without.size(), 2U);
  EXPECT_TRUE(without[1].isExcluded && !without[1].isFoundByGeometry);
  EXPECT_TRUE(setup::hasClickedSample(without));
  const auto again = learnFromClicks(scene.rig, {scene.images, {}, 0}, without);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->samples, without);
  EXPECT_FALSE(setup::hasClickedSample(setup::withoutSample(without, 0)));
}

// Two bands of one color: the second is learned beside the first, which is neither it nor what it
// has to be told from.
TEST(ClickLearningResult, TakesAnotherTargetOfTheColorForNeither) {
  const Eigen::Vector3d other = kBall + Eigen::Vector3d(-0.5, 0.5, 0.0); // beside it in both images
  PaintedRig scene(2);
  scene.paintInAll(kBall, kRadius, kRed);
  scene.paintInAll(other, kRadius, kRed);
  const std::vector<color::ColorSample> taken{scene.clickOn(0, other, kRadius),
                                              scene.clickOn(1, other, kRadius)};
  const std::vector<color::ColorSample> click{scene.clickOn(0, kBall, kRadius)};
  const auto alone = learnFromClicks(scene.rig, {scene.images, {}, 0}, click);
  ASSERT_TRUE(alone);
  EXPECT_LT(alone->color.assessment.score(), 90); // as much of the color is no target
  Project project;
  for (const Camera& camera : scene.rig) {
    project.cameras.emplace_back().camera = camera;
  }
  project.targets.resize(2);
  project.targets[0].samples = taken;
  const auto beside = setup::learnFromClicks(project, 1, {scene.images, {}, 0}, click);
  ASSERT_TRUE(beside);
  EXPECT_GE(beside->color.assessment.score(), 95);
  EXPECT_FALSE(beside->correction); // which of the two it is in the other image is left open
}

// A second ball of the color, which three cameras tell apart: the click says which one is meant.
TEST(ClickLearningResult, SaysWhereTheTargetIsWhenOthersMatchToo) {
  const Eigen::Vector3d other(-0.4, 0.3, -0.2);
  constexpr double kSmall = 0.05;
  PaintedRig scene(3);
  scene.paintInAll(kBall, kSmall, kRed);
  Project project;
  for (const Camera& camera : scene.rig) {
    project.cameras.emplace_back().camera = camera;
  }
  const std::vector<color::ColorSample> click{scene.clickOn(0, kBall, kSmall)};
  const auto only = setup::learnFromClicks(project, -1, {scene.images, {}, 0}, click);
  ASSERT_TRUE(only);
  EXPECT_EQ(only->centers.size(), 3U);
  EXPECT_FALSE(only->correction) << "its color says which one it is";

  scene.paintInAll(other, 0.5 * kSmall, kRed);
  const auto result = setup::learnFromClicks(project, -1, {scene.images, {}, 0}, click);
  ASSERT_TRUE(result);
  ASSERT_TRUE(result->correction);
  EXPECT_EQ(result->correction->frame, 0);
  EXPECT_LT((result->correction->position - kBall).norm(), 0.01); // 1.5 px at 2 m
  project.targets.emplace_back();
  setup::applyLearningResult(*result, 0, project);
  EXPECT_EQ(project.targets[0].samples, result->samples);
  ASSERT_EQ(project.corrections.size(), 1U);

  // A correction of a click that stays is kept as it is.
  project.corrections[0].position = other;
  setup::applyLearningResult(*result, 0, project);
  EXPECT_EQ(project.corrections[0].position, other);

  // One of a click that another has replaced is not: it may have been of another object.
  setup::ClickLearningResult another = *result;
  another.samples[0].x += 1.0;
  setup::applyLearningResult(another, 0, project);
  ASSERT_EQ(project.corrections.size(), 1U);
  EXPECT_EQ(project.corrections[0].position, result->correction->position);
}

TEST(ClickLearningResult, ComparesRadii) {
  EXPECT_EQ(setup::compareRadius(0.035, 0.040), setup::RadiusFit::Fits);
  EXPECT_EQ(setup::compareRadius(0.070, 0.036), setup::RadiusFit::IsDiameter);
  EXPECT_EQ(setup::compareRadius(100.0, 0.036), setup::RadiusFit::Differs);
  EXPECT_EQ(setup::compareRadius(0.010, 0.036), setup::RadiusFit::Differs);
}

} // namespace
} // namespace dewpoint::tests
