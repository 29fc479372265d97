// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/moved_files.h"
#include "core/project/project.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// A file or folder that a project names, and that is not there.
struct MissingFile {
  enum class Kind { Video, Images, EmptyRoom, Calibration, Truth, Scene };
  Kind kind = Kind::Video;
  int camera = -1;            ///< of this camera; -1: of the whole project
  std::string cameraName;     ///< empty where it belongs to no camera
  std::filesystem::path path; ///< absolute

  bool isFolder() const { return kind == Kind::Images; }
  bool operator==(const MissingFile&) const = default;
};

/// The missing files of a project file, each once, as far as it can be read; `moved`: where some
/// are by now. What is wrong with the project besides is not reported here. As readTomlFile() where
/// it fails.
Result<std::vector<MissingFile>> missingFilesOf(const std::filesystem::path& file,
                                                const MovedFiles& moved = {});

/// The same of a project that is in no file as it is.
std::vector<MissingFile> missingFilesOf(const Project& project);

/// Where missing files are, now that one of them was found: the others may lie beside it as they
/// did before, or under the same name in its folder. Those that are not there are left out.
MovedFiles foundBeside(const std::vector<MissingFile>& missing, const MissingFile& located,
                       const std::filesystem::path& found);

/// The project with its files where they are by now.
Project withMovedFiles(Project project, const MovedFiles& moved);

} // namespace dewpoint::setup
