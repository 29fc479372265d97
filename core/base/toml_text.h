// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <toml++/toml.h>

#include <filesystem>
#include <string>

namespace dewpoint::base {

/// Parses TOML. NotParsed gives the line and what was expected there; nesting of keys, arrays and
/// tables deeper than limits::kMostNesting is also NotParsed. `file` is for the message.
Result<toml::table> parseToml(const std::string& text, const std::string& file);

/// Reads and parses a TOML file. Errors: those of readTextFile() and parseToml().
Result<toml::table> readTomlFile(const std::filesystem::path& file);

/// Quotes a text for TOML. Bytes that are not valid UTF-8, which TOML cannot hold, become question
/// marks.
std::string quoted(const std::string& text);

} // namespace dewpoint::base
