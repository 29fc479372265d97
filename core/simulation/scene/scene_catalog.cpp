// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/scene/scene_catalog.h"

#include "core/base/text_file.h"
#include "core/simulation/scene/scene_file.h"

#include <filesystem>

namespace dewpoint::simulation {
namespace {

Scene builtIn(const std::string& name, Motion motion) {
  Scene scene = demoScene();
  scene.name = name;
  scene.balls.front().motion = motion;
  scene.balls.front().stillSeconds = 0.0;
  return scene;
}

// Chosen so that the eye can follow the 15 to 25 iterations, one per frame, in which method barrera
// converges, and so that the ball rests until then.
constexpr double kSlowRate = 8.0;    ///< frames per second
constexpr double kSlowRest = 5.0;    ///< seconds
constexpr double kSlowPeriod = 12.0; ///< seconds

Scene slowDemo(const std::string& name) {
  Scene scene = demoScene();
  scene.name = name;
  scene.framesPerSecond = kSlowRate;
  scene.balls.front().stillSeconds = kSlowRest;
  scene.balls.front().period = kSlowPeriod;
  return scene;
}

Scene firstCameraOnly(const std::string& name) {
  Scene scene = builtIn(name, Motion::Smooth);
  scene.cameras.resize(1);
  return scene;
}

} // namespace

const std::vector<std::string>& sceneNames() {
  static const std::vector<std::string> names{"demo",  "converge",    "one-camera",
                                              "still", "smooth",      "fast",
                                              "jump",  "look-alikes", "occluder"};
  return names;
}

Result<Scene> loadScene(const std::string& nameOrTomlFile) {
  const std::string& name = nameOrTomlFile;
  if (name == "demo") {
    return demoScene();
  }
  if (name == "converge") {
    return slowDemo(name);
  }
  if (name == "one-camera") {
    return firstCameraOnly(name);
  }
  if (name == "still") {
    return builtIn(name, Motion::Still);
  }
  if (name == "fast") {
    return builtIn(name, Motion::Fast);
  }
  if (name == "jump") {
    Scene scene = builtIn(name, Motion::Jump);
    scene.balls.front().period = 2.0;
    return scene;
  }
  if (name == "smooth" || name == "look-alikes" || name == "occluder") {
    Scene scene = builtIn(name, Motion::Smooth);
    scene.distractorCount = name == "look-alikes" ? 3 : 0;
    scene.hasOccluder = name == "occluder";
    return scene;
  }
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(name, ignored)) {
    return failure(ErrorCode::FileMissing, name, "",
                   "neither a scene file nor one of demo, converge, one-camera, still, smooth, "
                   "fast, jump, look-alikes, occluder");
  }
  return readTextFile(name).and_then(
      [&](const std::string& text) { return parseScene(text, name); });
}

} // namespace dewpoint::simulation
