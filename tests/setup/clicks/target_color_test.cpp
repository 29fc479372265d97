// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/clicks/target_color.h"

#include <gtest/gtest.h>

#include <vector>

namespace dewpoint::tests {
namespace {

const ColorRange kReds{340.0, 20.0, 0.3};
const ColorRange kBlues{200.0, 250.0, 0.3};
const ColorRange kGreens{90.0, 150.0, 0.3};

ColorSample sampleOf(const color::BgrColor& bgr, bool excluded = false) {
  ColorSample sample;
  sample.isExcluded = excluded;
  sample.colors.assign(10, bgr);
  return sample;
}

Target target() {
  Target target;
  target.color = kReds;
  target.otherColors = {kBlues, kGreens};
  target.samples = {sampleOf({40, 40, 200}), sampleOf({200, 60, 40}), sampleOf({200, 60, 40}, true),
                    sampleOf({40, 180, 40})};
  return target;
}

TEST(TargetColor, GoesWithTheSamplesThatShowIt) {
  Target without = target();
  setup::removeColor(1, without);
  EXPECT_EQ(without.color, kReds);
  EXPECT_EQ(without.otherColors, std::vector<ColorRange>{kGreens});
  const Target before = target();
  EXPECT_EQ(without.samples,
            (std::vector<ColorSample>{before.samples[0], before.samples[2], before.samples[3]}));
}

TEST(TargetColor, TheNextTakesThePlaceOfTheFirst) {
  Target without = target();
  setup::removeColor(0, without);
  EXPECT_EQ(without.color, kBlues);
  EXPECT_EQ(without.otherColors, std::vector<ColorRange>{kGreens});
}

TEST(TargetColor, TheOnlyOneStays) {
  Target one = target();
  one.otherColors.clear();
  const Target before = one;
  setup::removeColor(0, one);
  EXPECT_EQ(one, before);
}

TEST(TargetColor, EachCanBeChanged) {
  Target changed = target();
  setup::setColor(0, kGreens, changed);
  setup::setColor(2, kReds, changed);
  EXPECT_EQ(changed.color, kGreens);
  EXPECT_EQ(changed.otherColors, (std::vector<ColorRange>{kBlues, kReds}));
}

} // namespace
} // namespace dewpoint::tests
