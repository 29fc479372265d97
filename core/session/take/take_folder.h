// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <optional>

namespace dewpoint::session {

/// Highest number of a take.
inline constexpr int kHighestTakeNumber = 99999;

/// New folder of a take.
struct TakeFolder {
  std::filesystem::path path;
  int number = 0; ///< from 1
};

/// Creates the folder of a take, take-001, take-002, ..., in `parent`. Without a number, it gets
/// the next one after all takes in `parent`. Errors: FileUnwritable; BadValue if there is a take
/// with this number, or if it is not from 1 to kHighestTakeNumber.
Result<TakeFolder> makeTakeFolder(const std::filesystem::path& parent,
                                  std::optional<int> number = std::nullopt);

} // namespace dewpoint::session
