// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::capture {

/// Returns the number at the end of a name ("cam_07": 7), or nothing if there is none or it has
/// more than 18 digits.
std::optional<std::int64_t> numberAtEnd(std::string_view name);

/// Returns the position of each file in a sequence of numbered files with gaps, starting at 0 for
/// the first file. The number is at the end of the file name, before the extension. Numbers may
/// increase by any constant step, and a gap is a whole number of steps. Returns an empty list if no
/// file is missing or the names do not form such a sequence: names with different prefixes, numbers
/// that are times, or fewer existing than missing files.
std::vector<std::int64_t> sequenceNumbersOf(const std::vector<std::string>& files);

} // namespace dewpoint::capture
