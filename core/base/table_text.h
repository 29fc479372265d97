// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>

namespace dewpoint::base {

/// Reads a whole text file like readTextFile(), but with the larger limit limits::kMaxTableBytes,
/// for tables with one row per frame.
Result<std::string> readTableText(const std::filesystem::path& file);

} // namespace dewpoint::base
