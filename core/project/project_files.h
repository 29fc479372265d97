// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::project {

/// A file or folder that a run of a project reads.
struct ProjectFile {
  std::string name; ///< as in the project file: relative to its folder if the file is below it
  std::filesystem::path path; ///< absolute
};

/// What a run reads beside the project file: recordings, their times, background images, a
/// scene's file. Not the truth, which no result depends on.
std::vector<ProjectFile> filesOfRun(const Project& project);

/// Returns whether another run would see the same images. False with live cameras.
bool isRepeatable(const Project& project);

/// Returns the project as text, without parts that do not affect a run: markers, grid, measured
/// points, truth and window layout.
std::string textOfRun(const Project& project);

/// Returns the parameters that differ from the method's defaults, in the order of their
/// declarations, and the volume of interest, for example "particles=200 kld_error=0". Empty if
/// there are none.
std::string settingsOfRun(const Project& project);

} // namespace dewpoint::project
