// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>

namespace dewpoint::base {

/// What readTextFile() does, for tables with a row per frame: up to limits::kMostTableBytes.
Result<std::string> readTableText(const std::filesystem::path& file);

} // namespace dewpoint::base
