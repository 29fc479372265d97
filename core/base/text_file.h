// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>

namespace dewpoint::base {

/// Reads a whole text file, without a UTF-8 byte order mark. Errors: FileMissing; FileUnreadable,
/// also if the file is larger than limits::kMaxTextBytes.
Result<std::string> readTextFile(const std::filesystem::path& file);

/// Writes a text file atomically: writes a temporary file in the same folder, flushes it to disk
/// and renames it. Readers see either the complete old text or the complete new text, even after a
/// crash. Error: FileUnwritable with the reason.
Status writeTextFile(const std::filesystem::path& file, const std::string& text);

/// Writes a text directly to `file` and flushes the file to disk. Unlike writeTextFile(), this
/// function is not atomic. Use it to write several temporary files that are renamed only after all
/// of them are complete. Error: FileUnwritable; the file may then be incomplete.
Status writeAndFlush(const std::filesystem::path& file, const std::string& text);

} // namespace dewpoint::base
