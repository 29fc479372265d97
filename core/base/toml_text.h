// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <toml++/toml.h>

#include <filesystem>
#include <string>

namespace dewpoint::base {

/// Parses TOML. Error: NotParsed, with the line and what was expected there. Keys, arrays and
/// tables nested deeper than limits::kMaxNesting are also an error. `file` is the file name for the
/// error message.
Result<toml::table> parseToml(const std::string& text, const std::string& file);

/// Reads and parses a TOML file. Errors: those of readTextFile() and parseToml().
Result<toml::table> readTomlFile(const std::filesystem::path& file);

/// Returns the text as a quoted TOML string. Bytes that are not valid UTF-8, which TOML does not
/// allow, become question marks.
std::string tomlQuoted(const std::string& text);

} // namespace dewpoint::base
