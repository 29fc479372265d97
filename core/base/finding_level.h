// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <algorithm>
#include <functional>

namespace dewpoint::base {

/// Severity of a finding of a check, the most severe last.
enum class FindingLevel {
  Ok,     ///< as it should be
  Note,   ///< works, but may not be what you want
  Problem ///< must be fixed
};

/// Name of a level as lines of output and files show it: "ok", "note" or "problem".
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

/// The worst level of what was found, `level` being the member that says it; Ok of none.
template <class Range, class Level> FindingLevel worstLevel(const Range& found, Level level) {
  FindingLevel worst = FindingLevel::Ok;
  for (const auto& one : found) {
    worst = std::max(worst, std::invoke(level, one));
  }
  return worst;
}

} // namespace dewpoint::base
