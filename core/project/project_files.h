// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::project {

/// A file or folder that a run of a project reads.
struct ProjectFile {
  std::string name; ///< as the project file would call it: relative to its folder where it is below
  std::filesystem::path path; ///< absolute
};

/// What a run reads beside the project file: recordings, their times, pictures of the empty room, a
/// scene's file. Not the truth, which no result depends on.
std::vector<ProjectFile> filesOfRun(const Project& project);

/// Whether another run sees the same images: false with live cameras.
bool isRepeatable(const Project& project);

/// The project as text, without what no run depends on: markers, grid, measured points, truth and
/// the layout of the window.
std::string textOfRun(const Project& project);

/// What was chosen otherwise than the method's defaults, in the order of their declarations, and
/// the volume of interest: "particles=200 kld_error=0". Empty: nothing.
std::string settingsOfRun(const Project& project);

} // namespace dewpoint::project
