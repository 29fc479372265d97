// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::ui {

// How numbers and quantities are written in the language of the window: one function for each.

/// How a number is written that is negative, zero or not finite.
enum class NumberForm {
  Plain,   ///< as the language has it
  Signed,  ///< "+" before what is above zero
  Rounded, ///< rounded first: no minus before nothing but zeros
  Table    ///< with a true minus sign; "–" for what is not finite
};
/// With `decimals` decimals; "∞" for what is infinite.
QString numberText(double value, int decimals, NumberForm form = NumberForm::Plain);
/// As it stands in a table.
QString tableText(double value, int decimals);
/// With `digits` digits that count, at most four decimals and never as a power of ten.
QString digitsText(double value, int digits);
/// Three digits at most: a ratio of 1000 or of 1.08.
QString ratioText(double value);
/// Six digits at most: a bound or the default of a parameter, as it was declared.
QString declaredText(double value);
/// Four digits at most: 30 or 29.97 per second.
QString rateText(double perSecond);

/// How exactly a length is written, with its unit.
enum class LengthForm {
  Readout,  ///< "4.2 mm", "123 mm", "1.23 m": of something that changes all the time
  Short,    ///< "0.4 mm", "12 mm", "1.20 m": as short as it is exact enough
  TwoDigits ///< "0.35 mm", "12 mm", "1.2 m": an accuracy
};
QString lengthText(double meters, LengthForm form = LengthForm::Readout);
/// The unit of lengths that are compared with each other, however large they are.
enum class LengthScale { Millimeters, Centimeters, Meters };
/// "12.50 mm", "1.3 cm", "1.234 m": with `decimals` decimals.
QString lengthText(double meters, LengthScale scale, int decimals,
                   NumberForm form = NumberForm::Plain);
/// The number alone, where a heading or what follows has the unit.
QString lengthNumber(double meters, LengthScale scale, int decimals,
                     NumberForm form = NumberForm::Plain);

/// "0.31°"
QString angleText(double radians, int decimals, NumberForm form = NumberForm::Plain);
/// The degrees alone, where a heading has the unit.
QString angleNumber(double radians, int decimals, NumberForm form = NumberForm::Plain);
/// "0.20°", "1.2°": an accuracy, two digits that count.
QString angleAccuracyText(double radians);

/// A share (0 to 1) in percent: 100 only when nothing is left, 0 only when there is nothing.
QString shareText(double share);
/// A share in percent, the number alone.
QString percentText(double share, int decimals = 0);
/// The same of an accuracy: two digits that count.
QString percentAccuracyText(double share);

/// "4.40 s"
QString secondsText(double seconds, int decimals);
/// "12.3 ms"
QString millisecondsText(double milliseconds);
/// Seconds as a number of milliseconds alone, where a heading has the unit.
QString millisecondsNumber(double seconds, NumberForm form = NumberForm::Plain);
/// "850 µs", from 10 ms on "12.3 ms"
QString durationText(double microseconds);

/// "12.3 px"
QString pixelText(double pixels, int decimals = 1);
/// "0.0031 px": two digits at most, however small it is; how far pixels are off.
QString pixelDifferenceText(double pixels);

} // namespace dewpoint::ui
