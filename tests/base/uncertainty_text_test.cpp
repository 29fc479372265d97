// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/uncertainty_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace dewpoint::base {
namespace {

TEST(UncertaintyText, HasTwoDigitsAndNoExponent) {
  EXPECT_EQ(uncertaintyText(0.2, "degrees"), "+-0.2 degrees");
  EXPECT_EQ(uncertaintyText(0.0347, "%"), "+-0.035 %");
  EXPECT_EQ(uncertaintyText(9.96, "px"), "+-10 px");
  EXPECT_EQ(uncertaintyText(893.4, "px"), "+-890 px");
  EXPECT_EQ(uncertaintyText(123456.0, "px"), "+-120000 px");
  EXPECT_EQ(uncertaintyText(0.0, "px"), "+-0 px");
}

TEST(UncertaintyText, TwoDigitsOfANumberAlone) {
  EXPECT_EQ(twoSignificantDigitsText(893.4), "890");
  EXPECT_EQ(twoSignificantDigitsText(0.0000472), "0.000047");
  EXPECT_EQ(twoSignificantDigitsText(std::numeric_limits<double>::infinity()), "unknown");
}

TEST(UncertaintyText, OfALengthChoosesTheUnit) {
  EXPECT_EQ(lengthUncertaintyText(0.0031), "+-3.1 mm");
  EXPECT_EQ(lengthUncertaintyText(0.8934), "+-890 mm");
  EXPECT_EQ(lengthUncertaintyText(0.999), "+-1 m");
  EXPECT_EQ(lengthUncertaintyText(1.234), "+-1.2 m");
}

TEST(UncertaintyText, OfWhatIsNotFiniteIsUnknown) {
  EXPECT_EQ(uncertaintyText(std::numeric_limits<double>::quiet_NaN(), "px"), "unknown");
  EXPECT_EQ(lengthUncertaintyText(std::numeric_limits<double>::infinity()), "unknown");
}

} // namespace
} // namespace dewpoint::base
