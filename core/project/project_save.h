// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"

#include <filesystem>
#include <string>

namespace dewpoint::project {

/// Returns the text of the project file. Paths inside `folder` are relative to it; all others are
/// absolute.
std::string projectText(const Project& project, const std::filesystem::path& folder);
/// Saves a project. The text goes to a temporary file next to `file`, is flushed, and then replaces
/// `file`, so the old file is never damaged. Paths inside the folder of `file` are written relative
/// to it. Comments in the file that the project was loaded from are kept if the entries they belong
/// to still exist.
Status saveProject(const Project& project, const std::filesystem::path& file);

} // namespace dewpoint::project
