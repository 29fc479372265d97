// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/quantity_rule.h"
#include "tests/architecture/source_rules.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

using Found = std::vector<std::string>;

const std::string kFile = "ui/plots/plot_row.cpp";

TEST(QuantityRule, AUnitBehindANumberIsTheFormattersWork) {
  EXPECT_EQ(quantitiesByHand(kFile, "tr(\"%1: %2 px\")"), Found{"%2 px"});
  EXPECT_EQ(quantitiesByHand(kFile, "tr(\"off by up to %1 \"\n   \"cm)\")"), Found{"%1 cm"});
  EXPECT_EQ(quantitiesByHand(kFile, "tr(\"±%1°, %2 m.\")"), (Found{"%1°", "%2 m"}));
  EXPECT_EQ(quantitiesByHand(kFile, "tr(\"%1 s – %2\")"), Found{"%1 s"});

  EXPECT_EQ(quantitiesByHand(kFile, "tr(\"%1 m/s\")"), Found{"%1 m/s"});
  EXPECT_EQ(quantitiesByHand(kFile, "tr(\"at %2 m/s.\")"), Found{"%2 m/s"});

  EXPECT_EQ(quantitiesByHand(kFile, "tr(\"%1 samples, %2 m/s², %3 % of %4\")"), Found{});
  EXPECT_EQ(quantitiesByHand(kFile, "tr(\"speed, m/s\")"), Found{});
  EXPECT_EQ(quantitiesByHand(kFile, "/// \"%1 px\"\ntr(\"%1\", \"px\")"), Found{});
}

TEST(QuantityRule, ANumberIsNotBroughtToAnotherUnitAsItIsWritten) {
  EXPECT_EQ(quantitiesByHand(kFile, "numberText(1000.0 * meters, 1)"),
            (Found{"numberText(1000.0", "1000.0 *"}));
  EXPECT_EQ(quantitiesByHand(kFile, "numberText(1e3 * *camera.sigma, 2)"),
            (Found{"numberText(1e3", "1e3 *"}));
  EXPECT_EQ(quantitiesByHand(kFile, "tableNumberText(sigmaOf(sample) * 100.0, 1)"),
            Found{"tableNumberText(sigmaOf(sample) * 100.0"});
  EXPECT_EQ(quantitiesByHand(kFile, "significantDigitsText(angle * 180.0 / std::numbers::pi, 2)"),
            Found{"significantDigitsText(angle * 180.0"});

  EXPECT_EQ(quantitiesByHand(kFile, "numberText(value, 3); x = 100.0 * y;"), Found{});
}

TEST(QuantityRule, TheFormatterOfFrameNumbersAddsTheirOne) {
  EXPECT_EQ(quantitiesByHand(kFile, "tr(\"frame %1\").arg(box.frame + 1)"),
            Found{".arg(box.frame + 1"});
  EXPECT_EQ(quantitiesByHand(kFile, "QString::number(at.frame + 1);"),
            Found{"QString::number(at.frame + 1"});
  EXPECT_EQ(quantitiesByHand(kFile, "QLocale().toString(found.front().frame + 1)"),
            Found{"toString(found.front().frame + 1"});
  EXPECT_EQ(quantitiesByHand(kFile, "toString(std::max<std::int64_t>(0, frame_) + 1)"),
            Found{"toString(std::max<std::int64_t>(0, frame_) + 1"});
  EXPECT_EQ(quantitiesByHand(kFile, "frameNumberText(range.lastFrame + 1)"),
            Found{"NumberText(range.lastFrame + 1"});

  EXPECT_EQ(quantitiesByHand(kFile, "text.arg(frameNumberText(frame)); goToFrame(frame + 1);"),
            Found{});
  EXPECT_EQ(quantitiesByHand("ui/text/quantity_text.cpp", "numbers.toString(frame + 1)"), Found{});
  EXPECT_EQ(quantitiesByHand("app/dewpoint-cli/main.cpp", "text.arg(frame + 1)"), Found{});
}

TEST(QuantityRule, MillimetersAndMillisecondsAreMadeInOnePlace) {
  EXPECT_EQ(quantitiesByHand(kFile, "millisecondsText(1000.0 * latency)"), Found{"1000.0 *"});
  EXPECT_EQ(quantitiesByHand(kFile, "radius = field.value() / 1000.0;"), Found{"/ 1000.0"});
  EXPECT_EQ(quantitiesByHand(kFile, "constexpr double kMillimeters = 1000.0;"),
            Found{"kMillimeters = "});

  EXPECT_EQ(quantitiesByHand(kFile, "inMillimeters(radius); y->setRange(1.0, 1000.0);"), Found{});
}

TEST(QuantityRule, TheCommandLineBringsNumbersToAnotherUnitInOnePlace) {
  const std::string file = "app/dewpoint-cli/track/track_job.cpp";
  EXPECT_EQ(quantitiesByHand(file, "fmt::print(\"{:.1f} mm\", 1000.0 * rmse);"), Found{"1000.0 *"});
  EXPECT_EQ(quantitiesByHand(file, "fmt::print(\"{}\", angle * 180.0 / pi);"), Found{"* 180.0"});
  EXPECT_EQ(quantitiesByHand(file, "fmt::print(\"{}\", heading.yaw / kDegree);"),
            Found{"/ kDegree"});

  EXPECT_EQ(quantitiesByHand(file, "fmt::print(\"{}\", inDegrees(yaw)); x = turn * kDegree;"),
            Found{});
}

TEST(QuantityRule, SoDoesCore) {
  const std::string file = "core/trajectory/evaluation_text.cpp";
  EXPECT_EQ(quantitiesByHand(file, "return meters * 1000.0;"), Found{"* 1000.0"});
  EXPECT_EQ(quantitiesByHand(file, "fmt::format(\"{}\", 1e2 * share);"), Found{"1e2 *"});
  EXPECT_EQ(quantitiesByHand(file, "return angle / base::kDegree;"), Found{"/ base::kDegree"});
  EXPECT_EQ(quantitiesByHand(file, "constexpr double kMillimetersPerMeter = 1000.0;"),
            Found{"kMillimetersPerMeter = 1000.0"});

  EXPECT_EQ(quantitiesByHand(file, "x = inMillimeters(rmse); constexpr double kFar = 100.0;"),
            Found{});
  EXPECT_EQ(quantitiesByHand("core/base/units.h", "return 1000.0 * meters;"), Found{});
}

TEST(QuantityRule, TextsWithUnitsAreAskedOfTheWindowAlone) {
  const std::string planted = "namespace dewpoint::ui {\nauto a = tr(\"%1 mm\");\n}\n";
  EXPECT_EQ(violations(kFile, planted).size(), 1U);
  EXPECT_EQ(violations("ui/text/quantity_text.cpp", planted).size(), 0U);
  EXPECT_EQ(quantitiesByHand("app/dewpoint-cli/main.cpp", planted), Found{});
}

} // namespace
} // namespace dewpoint::tests
