// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::base {

/// How bad something is that a check found, the worst last.
enum class FindingLevel {
  Ok,     ///< as it should be
  Note,   ///< works, but may not be what was meant
  Problem ///< has to be mended
};

/// "ok", "note" or "problem", as it stands in front of a line and in files.
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

} // namespace dewpoint::base
