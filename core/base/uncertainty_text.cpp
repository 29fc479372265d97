// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/uncertainty_text.h"

#include "core/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::base {
namespace {

/// Two digits, as few decimals as they need.
std::string twoDigits(double value) {
  if (value == 0.0) {
    return "0";
  }
  constexpr int kMostDecimals = 9;
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
  const double step = std::pow(10.0, exponent - 1);
  std::string text = fmt::format("{:.{}f}", std::round(value / step) * step,
                                 std::clamp(1 - exponent, 0, kMostDecimals));
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
      text.pop_back();
    }
  }
  return text;
}

} // namespace

std::string twoSignificantDigitsText(double value) {
  return std::isfinite(value) ? twoDigits(value) : "unknown";
}

std::string uncertaintyText(double value, std::string_view unit) {
  return std::isfinite(value) ? fmt::format("+-{} {}", twoDigits(value), unit) : "unknown";
}

std::string lengthUncertaintyText(double meters) {
  constexpr double kRoundsToOneMeter = 0.995;
  return std::abs(meters) < kRoundsToOneMeter ? uncertaintyText(inMillimeters(meters), "mm")
                                              : uncertaintyText(meters, "m");
}

} // namespace dewpoint::base
