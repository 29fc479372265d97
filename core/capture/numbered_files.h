// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::capture {

/// Returns the number at the end of a name (7 for "cam_07"), or nothing if there is none or it has
/// more than 18 digits.
std::optional<std::int64_t> trailingNumber(std::string_view name);

/// Returns the position of each of `files` in the complete sequence, which includes missing files.
/// The first file has position 0. The number is at the end of the file name, before the extension.
/// Numbers may increase by any constant step; where files are missing, they increase by a multiple
/// of this step.
///
/// Returns an empty list if no file is missing, or if the names do not form such a sequence: fewer
/// than three files, different prefixes, numbers without a common step (such as times), or at least
/// as many missing as existing files.
std::vector<std::int64_t> sequenceNumbersOf(const std::vector<std::string>& files);

} // namespace dewpoint::capture
