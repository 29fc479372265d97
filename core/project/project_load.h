// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/moved_files.h"
#include "core/project/project.h"

#include <filesystem>

namespace dewpoint::project {

/// Reads and checks a project file (TOML). `moved` contains the current locations of files that
/// have moved. Errors name the file and the key.
Result<Project> loadProject(const std::filesystem::path& file, const MovedFiles& moved = {});

} // namespace dewpoint::project
