// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::project {

/// A file or folder that a run of a project reads.
struct ProjectFile {
  /// Name as written in the project file: relative to the project's folder if the file is inside
  /// this folder.
  std::string name;
  std::filesystem::path path; ///< absolute path
};

/// Returns the files that a run reads in addition to the project file: recordings, their capture
/// times, background images and the scene file. The ground truth is not included, because no result
/// depends on it.
std::vector<ProjectFile> runInputFiles(const Project& project);

/// Returns whether another run would read the same images. The result is false for live cameras.
bool isRepeatable(const Project& project);

/// Returns the project as text, without parts that do not affect a run: markers, grid, measured
/// points, truth and window layout.
std::string runInputText(const Project& project);

/// Returns the parameters that differ from the method's defaults, in declaration order, followed by
/// the volume of interest if there is one. Example: "particles=200 kld_error=0". The result is
/// empty if there is neither.
std::string nonDefaultSettings(const Project& project);

} // namespace dewpoint::project
