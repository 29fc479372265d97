// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/moved_files.h"
#include "core/project/project.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// A file or folder that is named in a project but does not exist.
struct MissingFile {
  enum class Kind { Video, Images, BackgroundImage, Calibration, Truth, Scene };
  Kind kind = Kind::Video;
  /// Index of the camera to which the file belongs; -1 if it belongs to the whole project.
  int camera = -1;
  std::string cameraName;     ///< name of this camera; empty if it belongs to the whole project
  std::filesystem::path path; ///< absolute path of the missing file or folder

  bool isFolder() const { return kind == Kind::Images; }
  bool operator==(const MissingFile&) const = default;
};

/// Returns the missing files named in a project file, without duplicates. Entries that cannot be
/// read are skipped, and other errors in the project are not reported. `moved` contains the current
/// locations of files that have moved. Fails only with the errors of readTomlFile().
Result<std::vector<MissingFile>> missingFilesOf(const std::filesystem::path& file,
                                                const MovedFiles& moved = {});

/// Returns the missing files of a project in memory, without duplicates.
std::vector<MissingFile> missingFilesOf(const Project& project);

/// Returns the locations of missing files after one of them, `located`, was found at `found`. Each
/// other file is searched for at the same path relative to the found file, and then by name in the
/// folder of the found file. Files that do not exist there are omitted.
MovedFiles locateRemainingFiles(const std::vector<MissingFile>& missing, const MissingFile& located,
                                const std::filesystem::path& found);

/// Returns the project with the paths of moved files replaced by their current locations.
Project withMovedFiles(Project project, const MovedFiles& moved);

} // namespace dewpoint::setup
