// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/simulate/record_office.h"

#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/progress.h"
#include "app/wiring/open_office.h"
#include "core/calibration/formats/calibration_file.h"
#include "core/capture/frame_writer.h"
#include "core/project/project_save.h"
#include "core/session/run/tracking_run.h"
#include "core/simulation/people/office.h"
#include "core/trajectory/trajectory_writer.h"

#include <fmt/format.h>

namespace dewpoint::app {
namespace {

Status writeVideo(const OfficeRenderer& renderer, std::size_t camera, const std::string& file,
                  Progress& progress) {
  const OfficeScene& scene = renderer.scene();
  auto writer = FrameWriter::createVideo(file, scene.framesPerSecond);
  if (!writer) {
    return tl::make_unexpected(writer.error());
  }
  for (std::int64_t frame = 0; frame < scene.frameCount; ++frame) {
    if (const auto written = writer->write(renderer.render(camera, frame)); !written) {
      return written;
    }
    progress.show(static_cast<std::int64_t>(camera) * scene.frameCount + frame + 1);
  }
  return writer->finish();
}

Status writeRoom(const OfficeRenderer& renderer, std::size_t camera, const std::string& folder) {
  auto writer = FrameWriter::createImageFolder(folder);
  if (!writer) {
    return tl::make_unexpected(writer.error());
  }
  if (const auto written = writer->write(renderer.backgroundImage(camera)); !written) {
    return written;
  }
  return writer->finish();
}

} // namespace

int recordOffice(const OfficeScene& scene, const std::filesystem::path& folder,
                 const std::string& option) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) {
    return reportError({ErrorCode::FileUnwritable, folder.string(), option, problem.message()});
  }
  simulation::ViewCache views;
  const OfficeRenderer renderer(scene, views);
  const auto whole = std::filesystem::absolute(folder);
  Project project = makeOfficeProject();
  project.name = "people in the office";
  project.scene.clear(); // its cameras are recordings from here on
  project.cameras.clear();
  project.truthFile = whole / "truth.csv";
  Progress progress("rendering",
                    scene.frameCount * static_cast<std::int64_t>(scene.cameras.size()));
  for (std::size_t k = 0; k < scene.cameras.size(); ++k) {
    ProjectCamera camera;
    camera.camera = scene.cameras[k];
    camera.source = SourceKind::Video;
    camera.location = (whole / fmt::format("camera-{}.mkv", k + 1)).string();
    camera.backgroundImageFile = (whole / fmt::format("empty-{}", k + 1)).string();
    for (const auto& written : {writeVideo(renderer, k, camera.location, progress),
                                writeRoom(renderer, k, camera.backgroundImageFile)}) {
      if (!written) {
        progress.finish();
        return reportError(written.error());
      }
    }
    project.cameras.push_back(std::move(camera));
  }
  progress.finish();
  for (const auto& written : {writeTrajectory(officeGroundTruth(renderer), folder / "truth.csv"),
                              saveCalibration(rigOf(project), folder / "calibration.toml"),
                              saveProject(project, folder / "project.toml")}) {
    if (!written) {
      return reportError(written.error());
    }
  }
  fmt::print("{}: {} frames of {} cameras, project.toml, calibration.toml, truth.csv\n",
             folder.string(), scene.frameCount, scene.cameras.size());
  return kExitDone;
}

} // namespace dewpoint::app
