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
  settings.size = WandScaleSource::Distance;
  note();
  settings.stick = true;
  note(); // one ball
  project.targets.resize(2);
  project.targets[1].name = "second";
  settings.other = "ball";
  note(); // twice the same
  EXPECT_EQ(sentences.size(), 6U);
  EXPECT_FALSE(sentences.contains(QString()));
}

TEST(WandText, EveryTouchHasItsText) {
  std::set<QString> words;
  for (int role = 0; role < kWandEventCount; ++role) {
    words.insert(touchText(static_cast<WandEvent>(role)));
  }
  EXPECT_EQ(words.size(), static_cast<std::size_t>(kWandEventCount));
}

} // namespace
} // namespace dewpoint::tests
