// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/progress.h"
#include "app/dewpoint-cli/simulate/record_board.h"
#include "app/dewpoint-cli/simulate/record_office.h"
#include "app/wiring/open_project.h"
#include "core/calibration/formats/calibration_file.h"
#include "core/capture/frame_writer.h"
#include "core/project/project_save.h"
#include "core/session/run/tracking_run.h"
#include "core/simulation/people/office_day.h"
#include "core/simulation/scene/scene_catalog.h"
#include "core/simulation/scene/scene_renderer.h"
#include "core/trajectory/trajectory_writer.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

namespace dewpoint::app {
namespace {

struct SimulateOptions {
  std::string scene = "demo";
  std::string out;
  std::optional<std::uint64_t> seed;
  std::optional<std::int64_t> frames;
  std::optional<std::string> motion;
  std::optional<int> distractors;
  bool occluder = false;
  bool images = false;
};

const std::map<std::string, Motion> kMotions{{"still", Motion::Still},
                                             {"smooth", Motion::Smooth},
                                             {"fast", Motion::Fast},
                                             {"jump", Motion::Jump}};

Result<Scene> chosenScene(const SimulateOptions& options) {
  auto scene = loadScene(options.scene);
  if (!scene) {
    return scene;
  }
  scene->seed = options.seed.value_or(scene->seed);
  scene->frameCount = options.frames.value_or(scene->frameCount);
  scene->distractorCount = options.distractors.value_or(scene->distractorCount);
  scene->hasOccluder = scene->hasOccluder || options.occluder;
  if (options.motion) {
    scene->balls.front().motion = kMotions.at(*options.motion);
  }
  return scene;
}

std::string fileName(std::string cameraName) {
  std::replace(cameraName.begin(), cameraName.end(), ' ', '-');
  return cameraName;
}

/// Renders one camera to disk; where its frames are is stored in `camera`.
Status writeCamera(const SceneRenderer& renderer, int index, const SimulateOptions& options,
                   const std::filesystem::path& folder, ProjectCamera& camera, Progress& progress) {
  const Scene& scene = renderer.scene();
  const std::string name = fileName(camera.camera.name);
  const auto path = folder / (options.images ? name : name + ".mkv");
  camera.location = std::filesystem::absolute(path).string();
  camera.source = options.images ? SourceKind::Images : SourceKind::Video;
  auto writer = options.images ? FrameWriter::createImageFolder(path.string())
                               : FrameWriter::createVideo(path.string(), scene.framesPerSecond);
  if (!writer) {
    return tl::make_unexpected(writer.error());
  }
  for (std::int64_t frame = 0; frame < scene.frameCount; ++frame) {
    if (const auto written = writer->write(renderer.render(index, frame)); !written) {
      return written;
    }
    progress.show(index * scene.frameCount + frame + 1);
  }
  return writer->finish();
}

/// The scene of people has a story of its own: of the options only those that are not about balls.
int simulateOffice(const SimulateOptions& options) {
  if (options.motion || options.distractors || options.occluder || options.images) {
    reportError({ErrorCode::BadValue, "", "--motion, --look-alikes, --occluder, --images",
                 "only for scenes with balls, not for the office"});
    return kExitUsage;
  }
  OfficeScene scene = builtInOfficeScene();
  scene.seed = options.seed.value_or(scene.seed);
  scene.frameCount = options.frames.value_or(scene.frameCount);
  return recordOffice(scene, options.out, "--out");
}

/// The scene to calibrate from has no ball and no noise: of the options only how long it is.
int simulateBoard(const SimulateOptions& options) {
  if (options.motion || options.distractors || options.occluder || options.images || options.seed) {
    reportError({ErrorCode::BadValue, "", "--seed, --motion, --look-alikes, --occluder, --images",
                 "only for scenes with balls, not for the board"});
    return kExitUsage;
  }
  return recordBoard(options.out, options.frames, "--out");
}

int simulate(const SimulateOptions& options) {
  if (options.scene == kOfficeSceneName) {
    return simulateOffice(options);
  }
  if (options.scene == kBoardSceneName) {
    return simulateBoard(options);
  }
  auto scene = chosenScene(options);
  if (!scene) {
    return reportError(scene.error());
  }
  const std::filesystem::path folder(options.out);
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) {
    return reportError({ErrorCode::FileUnwritable, folder.string(), "--out", problem.message()});
  }
  Project project = makeSceneProject(*scene, "");
  project.truthFile = std::filesystem::absolute(folder / "truth.csv");
  const SceneRenderer renderer(*scene);
  Progress progress("rendering",
                    scene->frameCount * static_cast<std::int64_t>(scene->cameras.size()));
  for (std::size_t k = 0; k < project.cameras.size(); ++k) {
    const auto written =
        writeCamera(renderer, static_cast<int>(k), options, folder, project.cameras[k], progress);
    if (!written) {
      return reportError(written.error());
    }
  }
  progress.finish();
  for (const auto& written : {writeTrajectory(sceneGroundTruth(*scene), folder / "truth.csv"),
                              saveCalibration(rigOf(project), folder / "calibration.toml"),
                              saveProject(project, folder / "project.toml")}) {
    if (!written) {
      return reportError(written.error());
    }
  }
  fmt::print("{}: {} frames of {} cameras, project.toml, calibration.toml, truth.csv\n",
             folder.string(), scene->frameCount, scene->cameras.size());
  return kExitDone;
}

} // namespace

void addSimulateCommand(CLI::App& app, int& exitCode) {
  auto* command =
      app.add_subcommand("simulate", "Render a scene with ground truth to disk, ready to track.");
  auto options = std::make_shared<SimulateOptions>();
  command
      ->add_option(
          "SCENE", options->scene,
          fmt::format("Built-in scene ({}; {}: people; {}: a board to calibrate from) or a "
                      "scene file (TOML)",
                      fmt::join(sceneNames(), ", "), kOfficeSceneName, kBoardSceneName))
      ->capture_default_str();
  command->add_option("--out", options->out, "Folder to write")->required();
  command->add_option("--seed", options->seed,
                      "Seed of the random noise and of the objects in the background");
  command->add_option("--frames", options->frames, "Number of frames")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{10'000'000}));
  std::vector<std::string> motions;
  motions.reserve(kMotions.size());
  for (const auto& [name, motion] : kMotions) {
    motions.push_back(name);
  }
  command->add_option("--motion", options->motion, "How the first ball moves")
      ->check(CLI::IsMember(motions));
  command
      ->add_option("--look-alikes", options->distractors,
                   "Number of further balls of the same color, which do not move")
      ->check(CLI::Range(0, 4));
  command->add_flag("--occluder", options->occluder,
                    "Move a box past camera 1, so that it hides the ball");
  command->add_flag("--images", options->images,
                    "Write folders of PNG images instead of lossless videos");
  command->callback([options, &exitCode] { exitCode = simulate(*options); });
}

} // namespace dewpoint::app
