// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"

#include <filesystem>
#include <string>

namespace dewpoint::project {

/// The project file: paths below `folder` relative to it, all others absolute.
std::string projectText(const Project& project, const std::filesystem::path& folder);
/// Writes beside, flushes, renames: the old file is never broken. Paths below the file's folder
/// are written relative to it. Comments in the file that the project was loaded from are kept where
/// what they stand at still exists.
Status saveProject(const Project& project, const std::filesystem::path& file);

} // namespace dewpoint::project
