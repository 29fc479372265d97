// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::session {

// Corrections are in the order of their `frame`.

/// The first frame for which other corrections hold; nothing when they are the same.
template <class Correction>
std::optional<std::int64_t> firstDifference(const std::vector<Correction>& before,
                                            const std::vector<Correction>& after) {
  const auto [a, b] = std::ranges::mismatch(before, after);
  if (a == before.end() && b == after.end()) {
    return std::nullopt;
  }
  return a == before.end() ? b->frame : b == after.end() ? a->frame : std::min(a->frame, b->frame);
}

/// What `after` adds to `before`, with which it begins; nothing when it does not.
template <class Correction>
std::optional<std::vector<Correction>> additions(const std::vector<Correction>& before,
                                                 const std::vector<Correction>& after) {
  const auto [a, b] = std::ranges::mismatch(before, after);
  return a == before.end() ? std::optional(std::vector<Correction>(b, after.end())) : std::nullopt;
}

} // namespace dewpoint::session
