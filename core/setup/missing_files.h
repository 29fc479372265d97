// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/moved_files.h"
#include "core/project/project.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// A file or folder that a project names but that does not exist.
struct MissingFile {
  enum class Kind { Video, Images, BackgroundImage, Calibration, Truth, Scene };
  Kind kind = Kind::Video;
  int camera = -1;            ///< index of its camera; -1: belongs to the whole project
  std::string cameraName;     ///< empty if it belongs to no camera
  std::filesystem::path path; ///< absolute

  bool isFolder() const { return kind == Kind::Images; }
  bool operator==(const MissingFile&) const = default;
};

/// Returns the missing files of a project file, each once, as far as it can be read. `moved` gives
/// the present location of files that have moved. Other errors in the project are not reported.
/// Returns the errors of readTomlFile().
Result<std::vector<MissingFile>> missingFilesOf(const std::filesystem::path& file,
                                                const MovedFiles& moved = {});

/// As above, for a project in memory.
std::vector<MissingFile> missingFilesOf(const Project& project);

/// Returns the location of missing files after one of them was found. The others may be in the same
/// relative position, or under the same name in its folder. Files that do not exist there are
/// omitted.
MovedFiles foundBeside(const std::vector<MissingFile>& missing, const MissingFile& located,
                       const std::filesystem::path& found);

/// Returns the project with the present locations of its files.
Project withMovedFiles(Project project, const MovedFiles& moved);

} // namespace dewpoint::setup
