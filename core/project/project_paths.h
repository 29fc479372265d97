// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/moved_files.h"

#include <filesystem>
#include <string>

namespace dewpoint::project {

/// Returns the text with `${NAME}` replaced by the environment variable of that name. The value of
/// the variable is not expanded again. Returns BadValue with the name if a variable is not set.
Result<std::string> expandVariables(std::string text);

/// Base folder for the relative paths in a project file, and the current locations of moved files.
struct ProjectPaths {
  std::filesystem::path folder;
  MovedFiles movedFiles;

  /// Returns the absolute path of a file whose `name` is given in the project, or its current
  /// location if the file has moved.
  std::filesystem::path pathOf(const std::string& name) const;
};

} // namespace dewpoint::project
