// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/angle.h"
#include "ui/text/quantity_text.h"

#include <QLocale>
#include <gtest/gtest.h>

#include <limits>

namespace dewpoint::tests {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kEndless = std::numeric_limits<double>::infinity();

TEST(QuantityText, ANumberHasItsForm) {
  EXPECT_EQ(numberText(1234.567, 2), QStringLiteral("1,234.57"));
  EXPECT_EQ(numberText(-0.5, 1), QStringLiteral("-0.5"));
  EXPECT_EQ(numberText(0.5, 1, NumberForm::Signed), QStringLiteral("+0.5"));
  EXPECT_EQ(numberText(-0.5, 1, NumberForm::Signed), QStringLiteral("-0.5"));
  EXPECT_EQ(numberText(-0.0004, 3), QStringLiteral("-0.000"));
  EXPECT_EQ(numberText(-0.0004, 3, NumberForm::Rounded), QStringLiteral("0.000"));
  EXPECT_EQ(numberText(-0.5, 1, NumberForm::Table), QStringLiteral("−0.5"));
  EXPECT_EQ(numberText(kUnknown, 1, NumberForm::Table), QStringLiteral("–"));
  EXPECT_EQ(numberText(kEndless, 1), QStringLiteral("∞"));
}

TEST(QuantityText, NumbersAreOfTheLanguage) {
  QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
  EXPECT_EQ(numberText(1.5, 2), QStringLiteral("1,50"));
  EXPECT_EQ(lengthText(0.0012, LengthForm::Short), QStringLiteral("1,2 mm"));
  QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
}

TEST(QuantityText, AReadoutHasADecimalOnlyWhereItSaysSomething) {
  EXPECT_EQ(lengthText(0.00424), QStringLiteral("4.2 mm"));
  EXPECT_EQ(lengthText(0.0424), QStringLiteral("42 mm"));
  EXPECT_EQ(lengthText(1.2345), QStringLiteral("1.23 m"));
  EXPECT_EQ(lengthText(-0.002), QStringLiteral("−2.0 mm"));
}

TEST(QuantityText, AShortLengthHasNoZerosAtItsEnd) {
  EXPECT_EQ(lengthText(0.0004, LengthForm::Short), QStringLiteral("0.4 mm"));
  EXPECT_EQ(lengthText(0.00025, LengthForm::Short), QStringLiteral("0.25 mm"));
  EXPECT_EQ(lengthText(0.005, LengthForm::Short), QStringLiteral("5 mm"));
  EXPECT_EQ(lengthText(0.1, LengthForm::Short), QStringLiteral("100 mm")); // zeros that count
  EXPECT_EQ(lengthText(0.9996, LengthForm::Short), QStringLiteral("1.00 m"));
}

TEST(QuantityText, AnAccuracyHasTwoDigits) {
  EXPECT_EQ(lengthText(0.00035, LengthForm::TwoDigits), QStringLiteral("0.35 mm"));
  EXPECT_EQ(lengthText(0.0031, LengthForm::TwoDigits), QStringLiteral("3.1 mm"));
  EXPECT_EQ(lengthText(0.0123, LengthForm::TwoDigits), QStringLiteral("12 mm"));
  EXPECT_EQ(lengthText(1.23, LengthForm::TwoDigits), QStringLiteral("1.2 m"));
  EXPECT_EQ(significantDigitsText(0.0, 2), QStringLiteral("0"));
  EXPECT_EQ(ratioText(100.0), QStringLiteral("100"));
  EXPECT_EQ(ratioText(1.0833), QStringLiteral("1.08"));
  EXPECT_EQ(percentAccuracyText(0.001), QStringLiteral("0.10"));
  EXPECT_EQ(angleAccuracyText(0.2 * base::kDegree), QStringLiteral("0.20°"));
}

TEST(QuantityText, LengthsThatAreComparedKeepTheirUnit) {
  EXPECT_EQ(lengthText(0.00123, LengthScale::Millimeters, 1), QStringLiteral("1.2 mm"));
  EXPECT_EQ(lengthText(1.5, LengthScale::Millimeters, 2), QStringLiteral("1,500.00 mm"));
  EXPECT_EQ(lengthText(0.01, LengthScale::Centimeters, 1, NumberForm::Signed),
            QStringLiteral("+1.0 cm"));
  EXPECT_EQ(lengthText(-0.0012, LengthScale::Meters, 3, NumberForm::Table),
            QStringLiteral("−0.001 m"));
  EXPECT_EQ(lengthNumber(0.0707, LengthScale::Centimeters, 1), QStringLiteral("7.1"));
}

TEST(QuantityText, AnglesAreInDegrees) {
  EXPECT_EQ(angleText(0.31 * base::kDegree, 2), QStringLiteral("0.31°"));
  EXPECT_EQ(angleText(90.0 * base::kDegree, 0), QStringLiteral("90°"));
  EXPECT_EQ(angleText(1.2 * base::kDegree, 2, NumberForm::Signed), QStringLiteral("+1.20°"));
  EXPECT_EQ(angleNumber(-2.5 * base::kDegree, 1), QStringLiteral("-2.5"));
}

TEST(QuantityText, WhatWasDeclaredIsAsShortAsItCanBe) {
  EXPECT_EQ(parameterValueText(0.05), QStringLiteral("0.05"));
  EXPECT_EQ(parameterValueText(20000.0), QStringLiteral("20,000"));
  EXPECT_EQ(rateText(30.0), QStringLiteral("30"));
  EXPECT_EQ(rateText(29.97003), QStringLiteral("29.97"));
}

TEST(QuantityText, RatesOfFramesHaveOneDecimal) {
  EXPECT_EQ(frameRateText(30.0), QStringLiteral("30.0 fps"));
  EXPECT_EQ(frameRateText(2532.32), QStringLiteral("2,532.3 fps"));
}

TEST(QuantityText, FramesAreCountedFromOneWithoutGroups) {
  EXPECT_EQ(frameNumberText(0), QStringLiteral("1"));
  EXPECT_EQ(frameNumberText(1233), QStringLiteral("1234"));
  EXPECT_EQ(frameNumberText(1233999), QStringLiteral("1234000"));
  QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
  EXPECT_EQ(frameNumberText(12344), QStringLiteral("12345"));
  QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
}

TEST(QuantityText, SpeedsHaveTwoDecimals) {
  EXPECT_EQ(speedText(1.254), QStringLiteral("1.25 m/s"));
  EXPECT_EQ(speedText(kUnknown, NumberForm::Table), QStringLiteral("– m/s"));
}

TEST(QuantityText, AShareIsAllOrNothingOnlyWhenItIs) {
  EXPECT_EQ(percentText(0.0), QStringLiteral("0 %"));
  EXPECT_EQ(percentText(0.0001), QStringLiteral("1 %"));
  EXPECT_EQ(percentText(0.9999), QStringLiteral("99 %"));
  EXPECT_EQ(percentText(1.0), QStringLiteral("100 %"));
  EXPECT_EQ(percentNumber(0.0012, 2), QStringLiteral("0.12"));
}

TEST(QuantityText, DurationsAreShownAsOnAClock) {
  EXPECT_EQ(minutesAndSecondsText(7.9), QStringLiteral("0:07"));
  EXPECT_EQ(minutesAndSecondsText(754.0), QStringLiteral("12:34"));
  EXPECT_EQ(minutesAndSecondsText(3723.0), QStringLiteral("1:02:03"));
}

TEST(QuantityText, LabelsOfAnAxisCountMinutesWithoutHours) {
  EXPECT_EQ(minutesAndSecondsText(7.0, ClockForm::Axis), QStringLiteral("7 s"));
  EXPECT_EQ(minutesAndSecondsText(7.5, ClockForm::Axis, 1), QStringLiteral("7.5 s"));
  EXPECT_EQ(minutesAndSecondsText(65.0, ClockForm::Axis), QStringLiteral("1:05"));
  EXPECT_EQ(minutesAndSecondsText(65.25, ClockForm::Axis, 2), QStringLiteral("1:05.25"));
  EXPECT_EQ(minutesAndSecondsText(3723.0, ClockForm::Axis), QStringLiteral("62:03"));
}

TEST(QuantityText, DurationsAndPixelsHaveTheirUnits) {
  EXPECT_EQ(durationText(850.4), QStringLiteral("850 µs"));
  EXPECT_EQ(durationText(12345.0), QStringLiteral("12.3 ms"));
  EXPECT_EQ(millisecondsText(0.26), QStringLiteral("0.3 ms"));
  EXPECT_EQ(millisecondsNumber(-0.0123, NumberForm::Signed), QStringLiteral("-12.3"));
  EXPECT_EQ(secondsText(4.4, 2), QStringLiteral("4.40 s"));
  EXPECT_EQ(pixelText(12.34), QStringLiteral("12.3 px"));
  EXPECT_EQ(pixelText(0.4567, 3), QStringLiteral("0.457 px"));
  EXPECT_EQ(pixelDifferenceText(0.00312), QStringLiteral("0.0031 px"));
  EXPECT_EQ(pixelDifferenceText(3.4e-13), QStringLiteral("0.0001 px"));
}

} // namespace
} // namespace dewpoint::tests
