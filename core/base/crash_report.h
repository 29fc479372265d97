// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/floors.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace dewpoint::base {

/// Notes something that may help to explain a crash, such as an action of the user. Only the newest
/// kCrashNotes notes are kept, each cut off after kCrashNoteLength bytes. Can be called from any
/// thread.
void noteForCrashReport(std::string_view note);

inline constexpr std::size_t kCrashNotes = 100;
inline constexpr std::size_t kCrashNoteLength = 240;

/// From now on, a crash of this process leaves a report in `file`: `heading`, the signal, the notes
/// from oldest to newest, and the stack of the thread that crashed. After that, the process ends as
/// it would have without a report. The file is created only by a crash; its folder is created here.
/// A signal that already has a handler, such as that of a sanitizer, keeps it. Error:
/// FileUnwritable if the folder cannot be created or the path is too long.
Status enableCrashReport(const std::filesystem::path& file, std::string_view heading);

} // namespace dewpoint::base
