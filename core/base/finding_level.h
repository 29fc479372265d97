// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <algorithm>
#include <functional>

namespace dewpoint::base {

/// Severity of a finding, which is one result of a check. The levels are in ascending order.
enum class FindingLevel {
  Ok,     ///< no problem
  Note,   ///< works, but may not be what you want
  Problem ///< must be fixed
};

/// Returns the name of a level as used in output lines and files: "ok", "note" or "problem".
constexpr const char* levelName(FindingLevel level) {
  switch (level) {
  case FindingLevel::Ok:
    return "ok";
  case FindingLevel::Note:
    return "note";
  case FindingLevel::Problem:
    break;
  }
  return "problem";
}

/// Returns the most severe level among the elements of `found`, or Ok if there are no elements.
/// `level` is a pointer to the data member in which an element stores its level.
template <class Range, class Level> FindingLevel worstLevel(const Range& found, Level level) {
  FindingLevel worst = FindingLevel::Ok;
  for (const auto& one : found) {
    worst = std::max(worst, std::invoke(level, one));
  }
  return worst;
}

} // namespace dewpoint::base
