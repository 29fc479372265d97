// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_file.h"
#include "core/capture/frame_writer.h"
#include "core/project/project_save.h"
#include "core/setup/new_project/new_project.h"
#include "core/simulation/scene/scene_renderer.h"

#include <filesystem>

namespace dewpoint::tests {

/// The first frames of the demo as a person would have them: left.mkv, right.mkv and
/// calibration.toml. False when they cannot be written.
inline bool recordDemo(const std::filesystem::path& folder, int frames = 8) {
  Scene scene = demoScene();
  scene.frameCount = frames;
  const SceneRenderer renderer(scene);
  for (std::size_t k = 0; k < scene.cameras.size(); ++k) {
    auto writer = FrameWriter::createVideo((folder / (k == 0 ? "left.mkv" : "right.mkv")).string(),
                                           scene.framesPerSecond);
    for (std::int64_t frame = 0; writer && frame < scene.frameCount; ++frame) {
      if (!writer->write(renderer.render(static_cast<int>(k), frame))) {
        return false;
      }
    }
    if (!writer || !writer->finish()) {
      return false;
    }
  }
  return saveCalibration(scene.cameras, folder / "calibration.toml").has_value();
}

/// Records the demo and makes desk.toml, a project of it without targets. False when they cannot be
/// written.
inline bool recordDesk(const std::filesystem::path& folder) {
  NewProject wanted;
  wanted.cameras = {{"left", SourceKind::Video, (folder / "left.mkv").string()},
                    {"right", SourceKind::Video, (folder / "right.mkv").string()}};
  wanted.calibrationFile = (folder / "calibration.toml").string();
  if (!recordDemo(folder)) {
    return false;
  }
  const auto made = createNewProject(wanted);
  return made && saveProject(made->project, folder / "desk.toml").has_value();
}

} // namespace dewpoint::tests
