// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

#include <cstdint>

namespace dewpoint::ui {

// Formatting of numbers and quantities in the language of the window. Each quantity has one
// function.

/// Format of numbers that are negative, zero or not finite.
enum class NumberForm {
  Plain,   ///< as usual in the language
  Signed,  ///< "+" before positive numbers
  Rounded, ///< rounded first, so that zero has no minus sign
  Table    ///< with a real minus sign; "–" if not finite
};
/// Returns a number with `decimals` decimals; "∞" if it is infinite.
QString numberText(double value, int decimals, NumberForm form = NumberForm::Plain);
/// Returns a number in the form used in tables (NumberForm::Table).
QString tableNumberText(double value, int decimals);
/// Returns a number with `digits` significant digits, at most four decimals and no exponent.
QString significantDigitsText(double value, int digits);
/// Returns a ratio with at most three significant digits, for example "1.08".
QString ratioText(double value);
/// Returns a parameter bound or default as declared, with at most six digits.
QString parameterValueText(double value);
/// Returns a rate per second with at most four digits and without the unit, for example "30" or
/// "29.97".
QString rateText(double perSecond);
/// Returns a frame rate with its unit: "30.0 fps".
QString frameRateText(double framesPerSecond);
/// Returns the number of a frame, counted from 1 as in the timeline, without group separators: "1"
/// for frame 0, "1234" for frame 1233.
QString frameNumberText(std::int64_t frame);

/// Precision of a length that is written with its unit.
enum class LengthForm {
  Readout,  ///< "4.2 mm", "123 mm", "1.23 m": a value that changes continuously
  Short,    ///< "0.4 mm", "12 mm", "1.20 m": the shortest form that is precise enough
  TwoDigits ///< "0.35 mm", "12 mm", "1.2 m": an accuracy
};
/// Returns a length in the unit that suits its magnitude.
QString lengthText(double meters, LengthForm form = LengthForm::Readout);
/// Fixed unit for lengths that are compared with each other.
enum class LengthScale { Millimeters, Centimeters, Meters };
/// Returns a length with `decimals` decimals: "12.50 mm", "1.3 cm", "1.234 m".
QString lengthText(double meters, LengthScale scale, int decimals,
                   NumberForm form = NumberForm::Plain);
/// Returns a length without the unit, for use where a heading or the following text gives the unit.
QString lengthNumber(double meters, LengthScale scale, int decimals,
                     NumberForm form = NumberForm::Plain);

/// Returns an angle in degrees: "0.31°".
QString angleText(double radians, int decimals, NumberForm form = NumberForm::Plain);
/// Returns an angle in degrees without the unit, for use where a heading gives the unit.
QString angleNumber(double radians, int decimals, NumberForm form = NumberForm::Plain);
/// Returns the accuracy of an angle with two significant digits: "0.20°", "1.2°".
QString angleAccuracyText(double radians);

/// Returns a fraction (0 to 1) as a percentage. The result is 100 only if the fraction is exactly
/// 1, and 0 only if it is exactly 0.
QString percentText(double share);
/// Returns a fraction (0 to 1) as a percentage, without the percent sign.
QString percentNumber(double share, int decimals = 0);
/// Returns an accuracy, given as a fraction, as a percentage with two significant digits.
QString percentAccuracyText(double share);

/// Returns a time: "4.40 s".
QString secondsText(double seconds, int decimals);
/// Format of a time in minutes and seconds.
enum class ClockForm {
  Duration, ///< "0:07", "12:34", "1:02:03": whole seconds, as on a stopwatch
  Axis      ///< "7 s", "12:34.5", "62:03": labels of an axis, in minutes of any number
};
/// Returns a time in minutes and seconds. `decimals` is the number of decimals of the seconds;
/// ClockForm::Duration has none and omits what is less than a second.
QString minutesAndSecondsText(double seconds, ClockForm form = ClockForm::Duration,
                              int decimals = 0);
/// Returns a duration: "12.3 ms".
QString millisecondsText(double milliseconds);
/// Converts seconds to milliseconds and returns the number without the unit, for use where a
/// heading gives the unit.
QString millisecondsNumber(double seconds, NumberForm form = NumberForm::Plain);
/// Returns a duration: "850 µs"; durations of 10 ms or more as "12.3 ms".
QString durationText(double microseconds);

/// Returns a speed: "1.25 m/s".
QString speedText(double metersPerSecond, NumberForm form = NumberForm::Plain);

/// Returns a length in image pixels: "12.3 px".
QString pixelText(double pixels, int decimals = 1);
/// Returns the upper limit of a difference in image pixels, with at most two significant digits:
/// "0.0031 px". Limits below 0.0001 px are shown as 0.0001 px.
QString pixelDifferenceText(double pixels);

} // namespace dewpoint::ui
