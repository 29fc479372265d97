// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>
#include <string_view>

namespace dewpoint::trajectory {

/// Returns the text as a single line: line ends and other control characters become spaces.
std::string withoutLineBreaks(std::string_view text);
/// Returns the text in quotes; quotes inside it are doubled.
std::string quotedCsv(std::string_view text);
/// Returns the text as a CSV cell, quoted only where RFC 4180 or the comment character `#` requires
/// it.
std::string csvCell(std::string_view text);

} // namespace dewpoint::trajectory
