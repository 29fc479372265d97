// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/moved_files.h"

#include <filesystem>
#include <string>

namespace dewpoint::project {

/// The text with `${NAME}` replaced by the environment variable of that name, which is not expanded
/// again. BadValue with its name when a variable is not set.
Result<std::string> withVariables(std::string text);

/// The folder that relative paths of a project file count from, and what has moved.
struct ProjectPlace {
  std::filesystem::path folder;
  MovedFiles moved;

  /// The absolute path of a file that the project names so; where it is now if it was moved.
  std::filesystem::path pathOf(const std::string& name) const;
};

} // namespace dewpoint::project
