// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/people/people_overlay.h"
#include "core/session/snapshot/snapshot.h"
#include "core/session/view/target_colors.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/people_state.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

const ColorRange kGreen{108.0, 132.0, 0.4, 0.6, 0.4, 0.6};

Target targetOf(const std::string& name, const ColorRange& color) {
  Target target;
  target.name = name;
  target.color = color;
  return target;
}

TEST(TargetColors, TheLearnedColorCountsWhereTargetsAreFoundByColor) {
  const std::vector<Target> targets{targetOf("ball", kGreen)};
  EXPECT_EQ(displayColorSources(targets, methodFamily("dewpoint"))[0].learnedColors[0], kGreen);
  EXPECT_TRUE(displayColorSources(targets, methodFamily("histogram"))[0].learnedColors.empty());
}

TEST(TargetColors, APersonHasTheColorOfItsIdentity) {
  const auto sources =
      displayColorSources({targetOf(personName(2), ColorRange())}, methodFamily("people"));
  const cv::Scalar color = identityColor(2); // blue, green, red
  ASSERT_TRUE(sources[0].fixedColor.has_value());
  EXPECT_EQ(*sources[0].fixedColor,
            DisplayColor(DisplayColor(color[2], color[1], color[0]) / 255.0));
}

TEST(TargetColors, ASnapshotHasTheColorsOfItsProject) {
  TrackSnapshot snapshot;
  snapshot.family = methodFamily("dewpoint");
  snapshot.targets.emplace_back().target = targetOf("ball", kGreen);
  EXPECT_EQ(displayColorSources(snapshot),
            displayColorSources({snapshot.targets[0].target}, snapshot.family));
}

} // namespace
} // namespace dewpoint::tests
