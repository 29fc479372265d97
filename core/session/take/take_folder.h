// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <optional>

namespace dewpoint::session {

/// Highest number that a take (a recording of all cameras) can have.
inline constexpr int kHighestTakeNumber = 99999;

/// New folder of a take (a recording of all cameras).
struct TakeFolder {
  std::filesystem::path path;
  int takeNumber = 0; ///< number of the take, at least 1
};

/// Creates the folder of a new take (take-001, take-002, ...) in `parent`. If `number` is not set,
/// the take gets the next number after all takes in `parent`. Returns FileUnwritable if the folder
/// cannot be created, and BadValue if a take with this number exists or the number is not from 1 to
/// kHighestTakeNumber.
Result<TakeFolder> makeTakeFolder(const std::filesystem::path& parent,
                                  std::optional<int> number = std::nullopt);

} // namespace dewpoint::session
