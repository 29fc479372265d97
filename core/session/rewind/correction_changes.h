// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::session {

// The functions below require corrections that are ordered by `frame`.

/// Returns the first frame in which two lists of corrections differ; nothing if the lists are
/// equal.
template <class Correction>
std::optional<std::int64_t> firstDifferingFrame(const std::vector<Correction>& before,
                                                const std::vector<Correction>& after) {
  const auto [a, b] = std::ranges::mismatch(before, after);
  if (a == before.end() && b == after.end()) {
    return std::nullopt;
  }
  return a == before.end() ? b->frame : b == after.end() ? a->frame : std::min(a->frame, b->frame);
}

/// Returns the corrections that were appended to the list `before` to get `after`; nothing if
/// `after` does not begin with `before`.
template <class Correction>
std::optional<std::vector<Correction>> appendedCorrections(const std::vector<Correction>& before,
                                                           const std::vector<Correction>& after) {
  const auto [a, b] = std::ranges::mismatch(before, after);
  return a == before.end() ? std::optional(std::vector<Correction>(b, after.end())) : std::nullopt;
}

} // namespace dewpoint::session
