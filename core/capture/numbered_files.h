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

/// Index of each file in a numbered sequence, from 0 for the first file, when some files of the
/// sequence are missing. The numbers are at the end of the names, before the extension. They may
/// rise by any step; a gap is a whole number of steps. Empty if no file is missing, or if the names
/// do not form such a sequence (different prefixes, numbers that are times, or fewer files present
/// than missing).
std::vector<std::int64_t> numberedPlaces(const std::vector<std::string>& files);

} // namespace dewpoint::capture
