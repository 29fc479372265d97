// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/entered_place.h"

#include <cmath>
#include <initializer_list>
#include <limits>

namespace dewpoint::ui {

namespace {

std::optional<double> secondsIn(const QString& number, const QLocale& locale) {
  for (QLocale numbers : {locale, QLocale::c()}) {
    // Without groups, "2.500" has the same meaning in every language.
    numbers.setNumberOptions(numbers.numberOptions() | QLocale::RejectGroupSeparator);
    bool ok = false;
    const double seconds = numbers.toDouble(number, &ok);
    if (ok && std::isfinite(seconds)) {
      return seconds;
    }
  }
  return std::nullopt;
}

} // namespace

std::optional<EnteredPosition> parseEnteredPosition(const QString& text, const QLocale& locale) {
  const QString entered = text.trimmed();
  if (entered.endsWith(QLatin1Char('s'), Qt::CaseInsensitive)) {
    const auto seconds = secondsIn(entered.chopped(1).trimmed(), locale);
    return seconds ? std::optional<EnteredPosition>(*seconds) : std::nullopt;
  }
  for (const QLocale& numbers : {locale, QLocale::c()}) {
    bool ok = false;
    const qint64 frame = numbers.toLongLong(entered, &ok);
    if (ok && frame > std::numeric_limits<qint64>::min()) {
      return frame - 1; // people count from 1
    }
  }
  return std::nullopt;
}

} // namespace dewpoint::ui
