// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>

namespace dewpoint::base {

/// Reads a whole text file: FileMissing or FileUnreadable.
Result<std::string> readTextFile(const std::filesystem::path& file);

/// Writes beside, flushes to the disk, renames: a reader, or a crash at any time, finds the old
/// text or the new one, never half of one. FileUnwritable has the reason.
Status writeTextFile(const std::filesystem::path& file, const std::string& text);

/// The first half of that: writes the text into this very file and flushes it to the disk. For
/// files that belong together and are renamed when all of them are there. After FileUnwritable
/// there may be a part of it.
Status writeFlushed(const std::filesystem::path& file, const std::string& text);

} // namespace dewpoint::base
