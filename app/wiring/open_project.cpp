// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/wiring/open_project.h"

#include "app/wiring/open_office.h"
#include "core/capture/gstreamer/open_live.h"
#include "core/capture/recording.h"
#include "core/geometry/projector.h"
#include "core/project/project_check.h"
#include "core/project/project_load.h"
#include "core/session/run/background_images.h"
#include "core/session/run/tracking_run.h"
#include "core/setup/new_project/new_project.h"
#include "core/setup/new_project/project_recording.h"
#include "core/simulation/people/office_day.h"
#include "core/simulation/scene/scene_catalog.h"
#include "core/simulation/scene/scene_renderer.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/trajectory/trajectory_reader.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace dewpoint::app {
namespace {

/// Cameras that a scene brings, with the poses that the project gives them.
void takeCameras(Project& project, double framesPerSecond, const CameraRig& rig) {
  project.framesPerSecond = framesPerSecond;
  const std::vector<ProjectCamera> own = std::exchange(project.cameras, {});
  for (const auto& camera : rig) {
    project.cameras.push_back({camera, SourceKind::Simulation, "", 0});
    const auto adjusted = std::ranges::find_if(own, [&](const ProjectCamera& candidate) {
      return candidate.hasOwnCalibration && candidate.camera.name == camera.name &&
             candidate.camera.intrinsics.width == camera.intrinsics.width &&
             candidate.camera.intrinsics.height == camera.intrinsics.height;
    });
    if (adjusted != own.end()) {
      project.cameras.back() = *adjusted;
    }
  }
}

void fillFromScene(Project& project, const Scene& scene) {
  takeCameras(project, scene.framesPerSecond, scene.cameras);
}

Status fillFromNamedScene(Project& project) {
  if (project.scene == kOfficeSceneName) {
    const OfficeScene office = builtInOfficeScene();
    takeCameras(project, office.framesPerSecond, office.cameras);
    return {};
  }
  return loadScene(project.scene).map([&](const Scene& scene) { fillFromScene(project, scene); });
}

/// The method that a built-in scene is made to show, where it is not the default one.
std::string methodOfScene(const std::string& sceneName, const std::string& otherwise) {
  if (sceneName == "converge") {
    return "barrera";
  }
  return sceneName == "one-camera" ? "histogram" : otherwise;
}

/// The box around a ball in the first frame of the first camera, with a margin.
std::optional<TargetBox> boxAround(const Scene& scene, int ball) {
  constexpr double kMargin = 1.15;
  const Camera& camera = scene.cameras.front();
  const Eigen::Vector3d position = ballPosition(scene, ball, 0.0);
  const auto middle = Projector(camera).project(position);
  const double depth = (camera.cameraFromWorld * position).z();
  if (!middle || depth <= 0.0) {
    return std::nullopt;
  }
  const double radius = scene.balls[static_cast<std::size_t>(ball)].radius;
  const double half = std::round(kMargin * camera.intrinsics.focalX * radius / depth);
  TargetBox around;
  around.box = {std::round(middle->x() - half), std::round(middle->y() - half), 2.0 * half,
                2.0 * half};
  return around;
}

Result<std::unique_ptr<FrameSetSource>> openSimulation(const Scene& scene) {
  const auto renderer = std::make_shared<const SceneRenderer>(scene);
  std::vector<RecordedCamera> cameras;
  for (std::size_t k = 0; k < scene.cameras.size(); ++k) {
    RecordedCamera camera;
    camera.name = scene.cameras[k].name;
    camera.kind = RecordedCamera::Kind::Generated;
    camera.width = scene.cameras[k].intrinsics.width;
    camera.height = scene.cameras[k].intrinsics.height;
    camera.generate = [renderer, k](std::int64_t frame) {
      return renderer->render(static_cast<int>(k), frame);
    };
    camera.generatedFrameCount = scene.frameCount;
    cameras.push_back(std::move(camera));
  }
  return openRecording(cameras, scene.framesPerSecond);
}

using SeenSizes = std::vector<std::optional<cv::Size>>;

bool isComplete(const SeenSizes& sizes) {
  return std::ranges::all_of(sizes, [](const auto& size) { return size.has_value(); });
}

/// The size of the first image of each of these cameras; nothing for those that send none in time.
SeenSizes seenSizes(FrameSetSource& source, const std::vector<std::size_t>& cameras) {
  using Clock = std::chrono::steady_clock;
  constexpr auto kPatience = std::chrono::seconds(3); // as long as opening a stream may take
  SeenSizes sizes(cameras.size());
  const auto deadline = Clock::now() + kPatience;
  while (!isComplete(sizes) && Clock::now() < deadline) {
    const auto set = source.next();
    for (std::size_t k = 0; set && *set && k < cameras.size(); ++k) {
      if (const FramePtr& frame = (*set)->frames[cameras[k]]) {
        sizes[k] = frame->image.size();
      }
    }
  }
  return sizes;
}

/// Cameras that nobody has calibrated may send images of any size: what is guessed of them takes
/// the size that comes.
Result<std::unique_ptr<FrameSetSource>> openLiveCameras(Project& project,
                                                        const std::vector<EncodedFeedPtr>& feeds) {
  std::vector<LiveCamera> cameras = liveCamerasOf(project);
  std::vector<std::size_t> guessed;
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    if (hasGuessedPose(project, k) && hasGuessedLens(project, k)) {
      guessed.push_back(k);
      cameras[k].width = cameras[k].height = 0;
    }
  }
  auto source = openLive(cameras, feeds);
  if (!source || guessed.empty()) {
    return source;
  }
  const SeenSizes sizes = seenSizes(**source, guessed);
  for (std::size_t k = 0; k < guessed.size(); ++k) {
    if (sizes[k]) {
      guessCalibration(project, guessed[k], *sizes[k]);
    }
  }
  return isComplete(sizes) ? std::move(source) : openLive(liveCamerasOf(project), feeds);
}

Result<std::unique_ptr<FrameSetSource>> openRecordings(const Project& project) {
  std::vector<RecordedCamera> cameras;
  for (const auto& camera : project.cameras) {
    cameras.push_back(setup::recordedCamera(camera));
  }
  return openRecording(cameras, project.framesPerSecond);
}

/// `feeds` gets those of live cameras.
Result<std::unique_ptr<FrameSetSource>> openSource(Project& project,
                                                   std::vector<EncodedFeedPtr>& feeds) {
  const auto live = std::ranges::count_if(project.cameras, &ProjectCamera::isLive);
  if (live == 0) {
    return openRecordings(project);
  }
  if (live < static_cast<std::ptrdiff_t>(project.cameras.size())) {
    return failure(ErrorCode::Mismatch, project.file.string(), "camera",
                   "live cameras and recordings cannot be mixed in one project");
  }
  feeds.resize(project.cameras.size());
  std::ranges::generate(feeds, [] { return std::make_shared<EncodedFeed>(); });
  return openLiveCameras(project, feeds);
}

} // namespace

std::vector<LiveCamera> liveCamerasOf(const Project& project) {
  std::vector<LiveCamera> cameras;
  for (const auto& camera : project.cameras) {
    const auto& intrinsics = camera.camera.intrinsics;
    const bool isDevice = camera.source == SourceKind::Device;
    cameras.push_back({camera.camera.name, camera.location, camera.rotateDegrees, intrinsics.width,
                       intrinsics.height, camera.isMirrored, camera.delay,
                       isDevice ? camera.device : DeviceSettings{}, camera.crop});
  }
  return cameras;
}

Project makeSceneProject(const Scene& scene, const std::string& sceneName) {
  Project project;
  project.name = scene.name;
  project.scene = sceneName;
  project.method = methodOfScene(sceneName, project.method);
  project.parameters = ParameterValues(methodParameters(project.method));
  project.parameters.markAllAsGiven();
  const MethodFamily family = methodFamily(project.method);
  for (const auto& ball : scene.balls) {
    Target& target = project.targets.emplace_back();
    target.name = ball.name;
    target.radius = ball.radius;
    target.color = ColorRange{ball.hueMin,        ball.hueMax,       ball.saturationMin,
                              ball.saturationMax, ball.intensityMin, ball.intensityMax};
    if (!family.isDefined(target)) {
      target.box = boxAround(scene, static_cast<int>(project.targets.size()) - 1);
    }
  }
  fillFromScene(project, scene);
  return project;
}

Trajectory sceneGroundTruth(const Scene& scene) {
  Trajectory truth;
  truth.header.entries = {{"scene", scene.name}, {"seed", std::to_string(scene.seed)}};
  for (const auto& camera : scene.cameras) {
    truth.header.cameras.push_back({camera.name, camera.center(), camera.opticalAxis()});
  }
  for (std::int64_t frame = 0; frame < scene.frameCount; ++frame) {
    for (std::size_t k = 0; k < scene.balls.size(); ++k) {
      TrajectorySample sample;
      sample.time = static_cast<double>(frame) / scene.framesPerSecond;
      sample.frame = frame;
      sample.target = scene.balls[k].name;
      sample.position = ballPosition(scene, static_cast<int>(k), frameTime(scene, frame));
      sample.cameraCount = static_cast<int>(scene.cameras.size());
      truth.samples.push_back(std::move(sample));
    }
  }
  return truth;
}

Result<Project> resolveProject(const std::string& nameOrFile, const MovedFiles& moved) {
  const std::string name = nameOrFile.empty() ? "demo" : nameOrFile;
  std::error_code problem;
  const bool isFile = std::filesystem::is_regular_file(name, problem); // a folder is no project
  if (name == kOfficeSceneName && !isFile) {
    return makeOfficeProject();
  }
  const auto& builtIn = sceneNames();
  if (std::find(builtIn.begin(), builtIn.end(), name) != builtIn.end() && !isFile) {
    return loadScene(name).map([&](const Scene& scene) { return makeSceneProject(scene, name); });
  }
  auto project = loadProject(name, moved);
  if (project && !project->scene.empty()) {
    if (auto filled = fillFromNamedScene(*project); !filled) {
      return tl::make_unexpected(filled.error());
    }
  }
  return project;
}

Result<Project> completedProject(Project project) {
  // Only now is it known how large the images are: a box may lie beyond them.
  if (const auto checked =
          guessMissingCameras(project).and_then([&] { return checkProject(project); });
      !checked) {
    Error error = checked.error();
    error.file = error.file.empty() ? project.file.string() : error.file;
    return tl::make_unexpected(std::move(error));
  }
  if (!project.scene.empty() && project.scene != kOfficeSceneName &&
      !project.scene.ends_with(".toml")) {
    // The built-in ones were made for the methods' own defaults.
    project.parameters.markAllAsGiven();
  }
  return project;
}

Result<SessionInputs> openInputs(Project wanted) {
  SessionInputs inputs;
  auto settled = completedProject(std::move(wanted));
  if (!settled) {
    return tl::make_unexpected(settled.error());
  }
  Project& project = *settled;
  if (project.scene == kOfficeSceneName) {
    auto office = openOfficeInputs(project);
    if (!office) {
      return office;
    }
    inputs = std::move(*office);
  } else if (!project.scene.empty()) {
    const auto scene = loadScene(project.scene);
    if (!scene) {
      return tl::make_unexpected(scene.error());
    }
    inputs.truth = sceneGroundTruth(*scene);
    auto source = openSimulation(*scene);
    if (!source) {
      return tl::make_unexpected(source.error());
    }
    inputs.source = std::move(*source);
  } else {
    auto source = openSource(project, inputs.feeds);
    if (!source) {
      return tl::make_unexpected(source.error());
    }
    inputs.source = std::move(*source);
  }
  if (project.truthFile) {
    auto truth = readTrajectory(*project.truthFile);
    if (!truth) {
      return tl::make_unexpected(truth.error());
    }
    inputs.truth = std::move(*truth);
  }
  auto rooms = loadBackgroundImages(project);
  if (!rooms) {
    return tl::make_unexpected(rooms.error());
  }
  inputs.backgroundImages = std::move(*rooms);
  inputs.project = std::move(project);
  return inputs;
}

Result<SessionInputs> openProject(const SessionRequest& request) {
  if (request.project) {
    Project project = *request.project;
    const auto filled = project.scene.empty() ? Status() : fillFromNamedScene(project);
    return filled.and_then([&] { return openInputs(std::move(project)); });
  }
  return resolveProject(request.file.string(), request.movedFiles).and_then([](Project project) {
    return openInputs(std::move(project));
  });
}

} // namespace dewpoint::app
