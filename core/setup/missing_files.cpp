// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/missing_files.h"

#include "core/base/toml_text.h"
#include "core/project/project_format.h"
#include "core/project/project_migration.h"
#include "core/project/project_paths.h"

#include <algorithm>
#include <array>
#include <utility>

namespace dewpoint::setup {
namespace {

namespace fs = std::filesystem;
using Kind = MissingFile::Kind;

bool isThere(const fs::path& path) {
  std::error_code problem;
  return fs::exists(path, problem);
}

/// Collects what is not there, each file once.
class MissingFileList {
public:
  void check(const MissingFile& file) {
    if (!file.path.empty() && !isThere(file.path) &&
        std::ranges::find(files_, file.path, &MissingFile::path) == files_.end()) {
      files_.push_back(file);
    }
  }
  std::vector<MissingFile> take() { return std::move(files_); }

private:
  std::vector<MissingFile> files_;
};

/// The path under a key; empty when there is none that can be told.
fs::path pathUnder(const toml::table& table, const char* key, const ProjectPaths& place) {
  const auto text = table[key].value<std::string>();
  const auto expanded = text && !text->empty() ? expandVariables(*text) : std::string();
  return expanded && !expanded->empty() ? place.pathOf(*expanded) : fs::path();
}

constexpr std::array kCameraKeys{std::pair("video", Kind::Video), std::pair("images", Kind::Images),
                                 std::pair("empty_room", Kind::BackgroundImage)};

void checkCameras(const toml::table& table, const ProjectPaths& place, MissingFileList& missing) {
  const toml::array* cameras = table["camera"].as_array();
  for (std::size_t k = 0; cameras != nullptr && k < cameras->size(); ++k) {
    const toml::table* camera = (*cameras)[k].as_table();
    for (const auto& [key, kind] : kCameraKeys) {
      if (camera != nullptr) {
        missing.check({kind, static_cast<int>(k), (*camera)["name"].value_or(std::string()),
                       pathUnder(*camera, key, place)});
      }
    }
  }
}

} // namespace

Result<std::vector<MissingFile>> missingFilesOf(const fs::path& file, const MovedFiles& moved) {
  auto table = readTomlFile(file);
  if (!table) {
    return tl::make_unexpected(table.error());
  }
  if (const auto format = (*table)["format"].value<std::int64_t>();
      format && *format >= 1 && *format < kProjectFormat) {
    migrateProject(*table, *format);
  }
  const ProjectPaths place{fs::absolute(file).parent_path(), moved};
  MissingFileList missing;
  checkCameras(*table, place, missing);
  missing.check({Kind::Calibration, -1, "", pathUnder(*table, "calibration", place)});
  missing.check({Kind::Truth, -1, "", pathUnder(*table, "truth", place)});
  if ((*table)["scene"].value_or(std::string()).ends_with(".toml")) {
    missing.check({Kind::Scene, -1, "", pathUnder(*table, "scene", place)});
  }
  return missing.take();
}

std::vector<MissingFile> missingFilesOf(const Project& project) {
  MissingFileList missing;
  for (std::size_t k = 0; k < project.cameras.size(); ++k) {
    const ProjectCamera& camera = project.cameras[k];
    const bool isVideo = camera.source == SourceKind::Video;
    if (isVideo || camera.source == SourceKind::Images) {
      missing.check({isVideo ? Kind::Video : Kind::Images, static_cast<int>(k), camera.camera.name,
                     camera.location});
    }
    missing.check({Kind::BackgroundImage, static_cast<int>(k), camera.camera.name,
                   camera.backgroundImageFile});
  }
  missing.check({Kind::Truth, -1, "", project.truthFile.value_or(fs::path())});
  if (project.scene.ends_with(".toml")) {
    missing.check({Kind::Scene, -1, "", project.scene});
  }
  return missing.take();
}

MovedFiles locateRemainingFiles(const std::vector<MissingFile>& missing, const MissingFile& located,
                                const fs::path& found) {
  MovedFiles moved{{located.path, found}};
  const fs::path before = located.path.parent_path();
  const fs::path now = found.parent_path();
  for (const MissingFile& other : missing) {
    const fs::path asBefore = (now / other.path.lexically_relative(before)).lexically_normal();
    const fs::path beside = now / other.path.filename();
    if (moved.contains(other.path)) {
      continue;
    }
    for (const fs::path& candidate : {asBefore, beside}) {
      if (candidate != found && isThere(candidate)) { // recordings may have the same name
        moved.emplace(other.path, candidate);
        break;
      }
    }
  }
  return moved;
}

Project withMovedFiles(Project project, const MovedFiles& moved) {
  const auto now = [&](const fs::path& path) {
    const auto found = moved.find(path);
    return found != moved.end() ? found->second : path;
  };
  for (ProjectCamera& camera : project.cameras) {
    camera.location = now(camera.location).string();
    camera.backgroundImageFile = now(camera.backgroundImageFile).string();
  }
  if (project.truthFile) {
    project.truthFile = now(*project.truthFile);
  }
  project.scene = now(project.scene).string();
  return project;
}

} // namespace dewpoint::setup
