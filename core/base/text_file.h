// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>

namespace dewpoint::base {

/// Reads a whole text file. Errors: FileMissing, FileUnreadable.
Result<std::string> readTextFile(const std::filesystem::path& file);

/// Writes a text file atomically: writes a temporary file in the same folder, flushes it to the
/// disk and renames it. A reader, or the disk after a crash, has either the complete old text or
/// the complete new text. Error: FileUnwritable with the reason.
Status writeTextFile(const std::filesystem::path& file, const std::string& text);

/// First half of writeTextFile(): writes the text directly into `file` and flushes it to the disk.
/// Use it for files that belong together and are renamed when all of them are complete. After
/// FileUnwritable the file may be incomplete.
Status writeFlushed(const std::filesystem::path& file, const std::string& text);

} // namespace dewpoint::base
