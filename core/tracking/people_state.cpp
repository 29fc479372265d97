// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/people_state.h"

#include <fmt/format.h>

#include <charconv>

namespace dewpoint::tracking {

std::string personName(int identity) {
  return fmt::format("person {}", identity);
}

std::optional<int> personIdentity(std::string_view name) {
  constexpr std::string_view kPerson = "person ";
  int identity = 0;
  if (!name.starts_with(kPerson)) {
    return std::nullopt;
  }
  const char* const end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + kPerson.size(), end, identity);
  const bool whole = read.ec == std::errc() && read.ptr == end;
  return whole && identity > 0 ? std::optional(identity) : std::nullopt;
}

} // namespace dewpoint::tracking
