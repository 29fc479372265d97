// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <toml++/toml.h>

#include <filesystem>
#include <string>

namespace dewpoint::base {

/// Parses TOML; NotParsed with the line and what was expected there, also where keys, arrays
/// and tables are nested deeper than limits::kMostNesting. `file` is for the message.
Result<toml::table> parseToml(const std::string& text, const std::string& file);

/// Reads and parses a TOML file; what readTextFile() and parseToml() say.
Result<toml::table> readTomlFile(const std::filesystem::path& file);

/// A text as TOML writes it; bytes that are no UTF-8, which it cannot hold, become question marks.
std::string quoted(const std::string& text);

} // namespace dewpoint::base
