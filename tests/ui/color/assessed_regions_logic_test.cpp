// SPDX-License-Identifier: GPL-3.0-or-later
// What is written beside the regions that match a color fits what is said about the color.
#include "ui/color/assessed_regions.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

QString labelAt(double separability) {
  ColorAssessment assessment;
  assessment.separability = separability;
  DistractorRegion region;
  region.camera = 1;
  region.outline = {{0, 0}, {8, 0}, {8, 8}};
  assessment.distractors.push_back(region);
  return assessedRegions(assessment, {}).at(1).at(0).text;
}

TEST(AssessedRegions, OfAGoodColorLittleMatchesElsewhere) {
  EXPECT_EQ(labelAt(0.97), QStringLiteral("some pixels also have the target's color"));
  EXPECT_EQ(labelAt(0.6), QStringLiteral("also has the target's color"));
}

} // namespace
} // namespace dewpoint::tests
