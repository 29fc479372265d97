// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/quantity_text.h"

#include "core/base/units.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {
namespace {

class Quantity {
  Q_DECLARE_TR_FUNCTIONS(Quantity)
};

QString millimeters(const QString& number) {
  return Quantity::tr("%1 mm").arg(number);
}

QString centimetersText(const QString& number) {
  return Quantity::tr("%1 cm").arg(number);
}

QString metersText(const QString& number) {
  return Quantity::tr("%1 m").arg(number);
}

double unitsOf(double meters, LengthScale scale) {
  switch (scale) {
  case LengthScale::Millimeters:
    return inMillimeters(meters);
  case LengthScale::Centimeters:
    return inCentimeters(meters);
  case LengthScale::Meters:
    break;
  }
  return meters;
}

QString degreesText(const QString& number) {
  return Quantity::tr("%1°").arg(number);
}

QString pixelsText(const QString& number) {
  return Quantity::tr("%1 px").arg(number);
}

/// With so many digits at most, as short as it can be written.
QString shortest(double value, int digits) {
  return QLocale().toString(value, 'g', digits);
}

QString readout(double meters) {
  const double size = std::abs(meters);
  return size < 1.0
             ? lengthText(meters, LengthScale::Millimeters, size < 0.01 ? 1 : 0, NumberForm::Table)
             : lengthText(meters, LengthScale::Meters, 2, NumberForm::Table);
}

QString stopwatchText(double seconds) {
  const auto whole = static_cast<qint64>(seconds);
  const QChar zero(u'0');
  const qint64 hours = whole / 3600;
  const QString minutes = hours > 0 ? QStringLiteral("%1").arg(whole / 60 % 60, 2, 10, zero)
                                    : QString::number(whole / 60 % 60);
  const QString rest = QStringLiteral("%1:%2").arg(minutes).arg(whole % 60, 2, 10, zero);
  return hours > 0 ? QStringLiteral("%1:%2").arg(hours).arg(rest) : rest;
}

QString axisTimeText(double seconds, int decimals) {
  const int minutes = static_cast<int>(seconds / 60.0);
  if (minutes == 0) {
    return secondsText(seconds, decimals);
  }
  return QStringLiteral("%1:%2").arg(minutes).arg(
      numberText(seconds - 60.0 * minutes, decimals)
          .rightJustified(decimals > 0 ? 3 + decimals : 2, QLatin1Char('0')));
}

QString withoutTrailingZeros(QString text) {
  const QString point = QLocale().decimalPoint();
  if (text.contains(point)) {
    while (text.endsWith(u'0')) {
      text.chop(1);
    }
    if (text.endsWith(point)) {
      text.chop(point.size());
    }
  }
  return text;
}

QString shortLength(double meters) {
  const double size = inMillimeters(meters);
  if (size >= 999.5) {
    return metersText(numberText(meters, 2));
  }
  const int decimals = size >= 9.95 ? 0 : size >= 0.995 ? 1 : 2;
  return millimeters(withoutTrailingZeros(numberText(size, decimals)));
}

} // namespace

QString numberText(double value, int decimals, NumberForm form) {
  if (!std::isfinite(value)) {
    return form == NumberForm::Table ? QStringLiteral("–")
           : std::isinf(value)       ? QStringLiteral("∞")
                                     : QLocale().toString(value);
  }
  if (form == NumberForm::Rounded) {
    const double step = std::pow(10.0, decimals);
    value = std::round(value * step) / step + 0.0;
  }
  QString text = QLocale().toString(value, 'f', decimals);
  if (form == NumberForm::Table) {
    text.replace(QLatin1Char('-'), QChar(0x2212));
  }
  return form == NumberForm::Signed && value > 0.0 ? QStringLiteral("+") + text : text;
}

QString tableNumberText(double value, int decimals) {
  return numberText(value, decimals, NumberForm::Table);
}

QString significantDigitsText(double value, int digits) {
  const int decimals =
      value > 0.0 ? digits - 1 - static_cast<int>(std::floor(std::log10(value))) : 0;
  return numberText(value, std::clamp(decimals, 0, 4));
}

QString ratioText(double value) {
  return shortest(value, 3);
}

QString parameterValueText(double value) {
  return shortest(value, 6);
}

QString rateText(double perSecond) {
  return shortest(perSecond, 4);
}

QString frameRateText(double framesPerSecond) {
  return Quantity::tr("%1 fps").arg(numberText(framesPerSecond, 1));
}

QString frameNumberText(std::int64_t frame) {
  QLocale numbers;
  numbers.setNumberOptions(numbers.numberOptions() | QLocale::OmitGroupSeparator);
  return numbers.toString(static_cast<qlonglong>(frame) + 1); // people count from 1
}

QString lengthText(double meters, LengthForm form) {
  switch (form) {
  case LengthForm::Readout:
    break;
  case LengthForm::Short:
    return shortLength(meters);
  case LengthForm::TwoDigits:
    return meters < 1.0 ? millimeters(significantDigitsText(inMillimeters(meters), 2))
                        : metersText(significantDigitsText(meters, 2));
  }
  return readout(meters);
}

QString lengthText(double meters, LengthScale scale, int decimals, NumberForm form) {
  const QString number = lengthNumber(meters, scale, decimals, form);
  switch (scale) {
  case LengthScale::Millimeters:
    return millimeters(number);
  case LengthScale::Centimeters:
    return centimetersText(number);
  case LengthScale::Meters:
    break;
  }
  return metersText(number);
}

QString lengthNumber(double meters, LengthScale scale, int decimals, NumberForm form) {
  return numberText(unitsOf(meters, scale), decimals, form);
}

QString angleText(double radians, int decimals, NumberForm form) {
  return degreesText(angleNumber(radians, decimals, form));
}

QString angleNumber(double radians, int decimals, NumberForm form) {
  return numberText(inDegrees(radians), decimals, form);
}

QString angleAccuracyText(double radians) {
  return degreesText(significantDigitsText(inDegrees(radians), 2));
}

QString percentText(double share) {
  const bool part = share > 0.0 && share < 1.0;
  const double percent = part ? std::clamp(inPercent(share), 1.0, 99.0) : inPercent(share);
  return numberText(percent, 0) + QStringLiteral(" %");
}

QString percentNumber(double share, int decimals) {
  return numberText(inPercent(share), decimals);
}

QString percentAccuracyText(double share) {
  return significantDigitsText(inPercent(share), 2);
}

QString secondsText(double seconds, int decimals) {
  return Quantity::tr("%1 s").arg(numberText(seconds, decimals));
}

QString minutesAndSecondsText(double seconds, ClockForm form, int decimals) {
  return form == ClockForm::Axis ? axisTimeText(seconds, decimals) : stopwatchText(seconds);
}

QString millisecondsText(double milliseconds) {
  return Quantity::tr("%1 ms").arg(numberText(milliseconds, 1));
}

QString millisecondsNumber(double seconds, NumberForm form) {
  return numberText(inMilliseconds(seconds), 1, form);
}

QString durationText(double microseconds) {
  return microseconds < 10000.0 ? Quantity::tr("%1 µs").arg(numberText(microseconds, 0))
                                : millisecondsText(microseconds / 1000.0);
}

QString speedText(double metersPerSecond, NumberForm form) {
  return Quantity::tr("%1 m/s").arg(numberText(metersPerSecond, 2, form));
}

QString pixelText(double value, int decimals) {
  return pixelsText(numberText(value, decimals));
}

QString pixelDifferenceText(double value) {
  constexpr double kLeast = 1e-4; // less is rounding, and nobody's concern
  return pixelsText(shortest(std::max(value, kLeast), 2));
}

} // namespace dewpoint::ui
