// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_tickers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::ui {

namespace {

int decimalsOfStep(double step) {
  int decimals = 0;
  for (double scaled = step; std::abs(scaled - std::round(scaled)) > 1e-6 && decimals < 9;
       scaled *= 10.0) {
    ++decimals;
  }
  return decimals;
}

/// The next smaller one of 1, 2 and 5 times a power of ten; of such a number.
double smallerStep(double step) {
  const double decade = std::pow(10.0, std::floor(std::log10(step * 1.0001)));
  const double leading = std::round(step / decade);
  return leading > 2.0 ? 2.0 * decade : leading > 1.0 ? decade : 0.5 * decade;
}

std::int64_t multiplesWithin(const QCPRange& range, double step) {
  return static_cast<std::int64_t>(std::floor(range.upper / step)) -
         static_cast<std::int64_t>(std::ceil(range.lower / step)) + 1;
}

} // namespace

QVector<double> DecadeTicker::createTickVector(double, const QCPRange& range) {
  const int first = static_cast<int>(std::ceil(std::log10(range.lower)));
  const int last = static_cast<int>(std::floor(std::log10(range.upper)));
  const int gaps = std::max(1, maxTicks_ - 1);
  const int step = std::max(1, (last - first + gaps - 1) / gaps);
  QVector<double> ticks;
  for (int decade = first; decade <= last; decade += step) {
    ticks << std::pow(10.0, decade);
  }
  return ticks;
}

double StepTicker::getTickStep(const QCPRange& range) {
  const double step = QCPAxisTicker::getTickStep(range);
  if (!wholeNumbers_ || step == std::round(step)) {
    return step;
  }
  return step < 1.0 ? 1.0 : 2.0 * step; // 2.5
}

QVector<double> StepTicker::createTickVector(double step, const QCPRange& range) {
  step_ = step;
  return QCPAxisTicker::createTickVector(step, range);
}

QString StepTicker::getTickLabel(double tick, const QLocale& locale, QChar format, int precision) {
  constexpr double kLong = 1e5; // those and the tiniest are written with a power of ten
  constexpr int kMostDecimals = 4;
  const int decimals = decimalsOfStep(step_);
  if (std::abs(tick) >= kLong || decimals > kMostDecimals) {
    return QCPAxisTicker::getTickLabel(tick, locale, format, precision);
  }
  return locale.toString(std::abs(tick) < 1e-6 * step_ ? 0.0 : tick, 'f', decimals);
}

QVector<double> ValueTicker::createTickVector(double, const QCPRange& range) {
  const double size = range.upper - range.lower;
  if (!(size > 0.0) || !std::isfinite(size)) {
    return {};
  }
  double step = std::pow(10.0, std::ceil(std::log10(size)));
  while (multiplesWithin(range, step) < 2) {
    step = smallerStep(step);
  }
  while (multiplesWithin(range, smallerStep(step)) <= maxTicks_) {
    step = smallerStep(step);
  }
  const std::int64_t count = multiplesWithin(range, step);
  const std::int64_t most = std::max(2, maxTicks_);
  const std::int64_t stride = (count + most - 1) / most;
  const double first = std::ceil(range.lower / step);
  QVector<double> ticks;
  for (std::int64_t k = 0; k < count; k += stride) {
    // A tick at the very end of the range is not lost by rounding.
    ticks << std::clamp((first + static_cast<double>(k)) * step, range.lower, range.upper);
  }
  step_ = step;
  return ticks;
}

} // namespace dewpoint::ui
