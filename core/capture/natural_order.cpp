// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/natural_order.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace dewpoint::capture {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Cuts the run of digits off the front of `text`, without its leading zeros.
std::string_view takeNumber(std::string_view& text) {
  const auto end = std::ranges::find_if_not(text, isDigit);
  std::string_view number = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(number.size());
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

} // namespace

bool isBeforeInNaturalOrder(const std::string& left, const std::string& right) {
  std::string_view a = left;
  std::string_view b = right;
  while (!a.empty() && !b.empty()) {
    if (isDigit(a.front()) && isDigit(b.front())) {
      const auto numberA = takeNumber(a);
      const auto numberB = takeNumber(b);
      if (numberA.size() != numberB.size()) {
        return numberA.size() < numberB.size();
      }
      if (numberA != numberB) {
        return numberA < numberB;
      }
      continue;
    }
    if (a.front() != b.front()) {
      return static_cast<unsigned char>(a.front()) < static_cast<unsigned char>(b.front());
    }
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  // Equal but for leading zeros or an ending: any fixed order will do.
  return a.empty() != b.empty() ? a.empty() : left < right;
}

} // namespace dewpoint::capture
