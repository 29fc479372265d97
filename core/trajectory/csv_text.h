// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>
#include <string_view>

namespace dewpoint::trajectory {

/// Line ends and other control characters would break a file's lines: they become spaces.
std::string oneLine(std::string_view text);
/// In quotes; a quote within is doubled.
std::string inQuotes(std::string_view text);
/// Quoted only where the CSV rules (RFC 4180) or our comment sign need it.
std::string csvCell(std::string_view text);

} // namespace dewpoint::trajectory
