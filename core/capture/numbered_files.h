// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::capture {

/// Number at the end of a name ("cam_07": 7); nothing if there is none, or if it has more than 18
/// digits.
std::optional<std::int64_t> numberAtEnd(std::string_view name);

/// Where each file stands in a sequence of numbered files (their names end in numbers, before the
/// ending), from 0 for the first on, when some of the sequence are missing. Numbers may rise by any
/// step; a gap is a whole number of steps. Empty: none is missing, or the names are no such
/// sequence (another beginning, numbers that are times, or fewer files there than missing).
std::vector<std::int64_t> sequenceNumbersOf(const std::vector<std::string>& files);

} // namespace dewpoint::capture
