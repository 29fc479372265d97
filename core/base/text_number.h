// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace dewpoint::base {

/// Parses an entire text as a number with a decimal point, regardless of the locale. Returns
/// nothing if any part of the text is not numeric (such as a leading space or plus sign), or if the
/// number is out of range for the type. Floating-point types also accept infinity and NaN.
template <class Number> std::optional<Number> toNumber(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, number);
  return problem == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

} // namespace dewpoint::base
