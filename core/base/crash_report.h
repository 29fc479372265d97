// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/floors.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace dewpoint::base {

/// Stores a note for the report of a possible crash, such as an action of the user. Only the newest
/// kCrashNotes notes are kept. A note is cut off after kCrashNoteLength bytes. Can be called from
/// any thread.
void addCrashReportNote(std::string_view note);

inline constexpr std::size_t kCrashNotes = 100;
inline constexpr std::size_t kCrashNoteLength = 240;

/// Makes a later crash of this process write a report to `file`. The report contains `heading`, the
/// signal, the notes from oldest to newest, and the stack of the thread that crashed. The process
/// then ends as it would have without a report. This function creates the folder of `file`, but
/// only a crash creates `file` itself. If a signal already has a handler, such as one from a
/// sanitizer, that handler is kept. Error: FileUnwritable if the folder cannot be created or the
/// path is too long.
Status enableCrashReport(const std::filesystem::path& file, std::string_view heading);

} // namespace dewpoint::base
