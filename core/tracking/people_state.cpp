// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/people_state.h"

#include "core/base/text_number.h"

#include <fmt/format.h>

namespace dewpoint::tracking {

std::string personName(int identity) {
  return fmt::format("person {}", identity);
}

std::optional<int> identityFromName(std::string_view name) {
  constexpr std::string_view kPerson = "person ";
  if (!name.starts_with(kPerson)) {
    return std::nullopt;
  }
  const auto identity = toNumber<int>(name.substr(kPerson.size()));
  return identity && *identity > 0 ? identity : std::nullopt;
}

} // namespace dewpoint::tracking
