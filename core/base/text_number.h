// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace dewpoint::base {

/// The number that a whole text is, in any locale with a point; nothing where a part of it is none,
/// as a space or a plus sign before it, or where it is too large for the type. Of a floating-point
/// type also infinity and NaN are numbers.
template <class Number> std::optional<Number> numberFrom(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, number);
  return problem == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

} // namespace dewpoint::base
