// SPDX-License-Identifier: GPL-3.0-or-later
// Scene files that ask for more than a computer has: each is one sentence, at once.
#include "core/simulation/scene/scene_file.h"
#include "tests/fuzz/hostile_text.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

std::string problemOf(const std::string& text) {
  const auto scene = simulation::parseScene(text, "scene.toml");
  return scene ? "" : base::errorSentence(scene.error());
}

TEST(SceneLimits, OfOrdinaryScenesAreKept) {
  EXPECT_EQ(problemOf(corpusText("scene/scene.toml")), "");
  EXPECT_EQ(problemOf(""), "");
}

TEST(SceneLimits, AreThoseOfAllImagesTogether) {
  const std::string camera = "[[camera]]\nwidth = 8192\nheight = 8192\nfocal = [1, 1]\n"
                             "position = [0, 0, 0]\ntarget = [1, 1, 1]\n";
  std::string text;
  for (int k = 0; k < 5; ++k) {
    text += camera;
  }
  EXPECT_EQ(problemOf(text), "scene.toml: camera: not a usable value (335544320 pixels in all "
                             "images together; at most 268435456 are possible)");
  EXPECT_NE(problemOf("[[camera]]\nwidth = 1000000\nheight = 1000000\n"), "");
}

TEST(SceneLimits, CountCamerasBallsAndLights) {
  for (const char* thing : {"camera", "ball", "light"}) {
    std::string text;
    for (int k = 0; k <= 1000; ++k) {
      text += std::string("[[") + thing + "]]\n";
    }
    EXPECT_EQ(problemOf(text),
              std::string("scene.toml: ") + thing +
                  ": not a usable value (1001; at most 1000 are possible, line 1)");
  }
}

TEST(SceneLimits, NoFieldTakesWhatIsNoFiniteNumber) {
  const std::string whole = corpusText("scene/scene.toml");
  for (const NumberPlace& place : numberPlaces(whole)) {
    for (const char* number : {"nan", "inf", "1e400", "1e300"}) {
      std::string text = whole;
      text.replace(place.begin, place.count, number);
      EXPECT_NE(problemOf(text), "") << place.begin << " is now " << number;
    }
  }
}

} // namespace
} // namespace dewpoint::tests
