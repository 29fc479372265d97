// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "ui/calibration/wand/wand_text.h"

#include <gtest/gtest.h>

#include <set>

namespace dewpoint::tests {
namespace {

TEST(WandText, EveryObstacleIsASentenceOfItsOwn) {
  Project project;
  WandSettings settings;
  std::set<QString> sentences;
  const auto note = [&](const std::vector<MarkedInstant>& instants = {}) {
    sentences.insert(validationMessage(settings, instants, project));
  };
  note(); // no camera
  project.cameras.resize(2);
  note(); // no ball
  project.targets.resize(1);
  project.targets[0].name = "ball";
  EXPECT_TRUE(validationMessage(settings, {}, project).isEmpty());
  note({{10, 0.4, WandEvent::FallBegins}});
  settings.scaleSource = WandScaleSource::Distance;
  note();
  settings.usesStick = true;
  note(); // one ball
  project.targets.resize(2);
  project.targets[1].name = "second";
  settings.secondBallTarget = "ball";
  note(); // twice the same
  EXPECT_EQ(sentences.size(), 6U);
  EXPECT_FALSE(sentences.contains(QString()));
}

TEST(WandText, EveryTouchHasItsText) {
  std::set<QString> words;
  for (int role = 0; role < kWandEventCount; ++role) {
    words.insert(wandEventText(static_cast<WandEvent>(role)));
  }
  EXPECT_EQ(words.size(), static_cast<std::size_t>(kWandEventCount));
}

TEST(WandText, EveryMissingMotionHasItsText) {
  std::set<QString> texts;
  for (int kind = 0; kind <= static_cast<int>(MissingMotion::SeenTogether); ++kind) {
    texts.insert(motionGapMessage({.missingMotion = static_cast<MissingMotion>(kind),
                                   .cameras = {1, 0},
                                   .motionAmount = 0.06},
                                  {"left", "right"}));
  }
  for (int side = 0; side <= static_cast<int>(ImageSide::Bottom); ++side) {
    texts.insert(motionGapMessage({.missingMotion = MissingMotion::WholeImage,
                                   .cameras = {1},
                                   .motionAmount = 0.06,
                                   .side = static_cast<ImageSide>(side)},
                                  {"left", "right"}));
  }
  EXPECT_EQ(texts.size(), 11U); // 7 kinds, and 5 sides, one of which is among these
  for (const QString& text : texts) {
    EXPECT_FALSE(text.contains('%') && text.contains("%1")) << text.toStdString();
  }
}

TEST(WandText, KnownBetterGivesBothErrors) {
  WandRefinement refinement;
  const QString without = lessAccurateResultMessage(refinement);
  refinement.beforeError = 0.0015;
  refinement.accuracy->cameras = {{0.006, 0.001}};
  const QString text = lessAccurateResultMessage(refinement);
  EXPECT_NE(text, without);
  EXPECT_TRUE(text.contains("1.5 mm") && text.contains("6.0 mm")) << text.toStdString();
}

} // namespace
} // namespace dewpoint::tests
