// SPDX-License-Identifier: GPL-3.0-or-later
// S6: two to eight cameras, and cameras that drop out and return. S9: a camera that is bumped.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/simulation/room/room_view.h"
#include "core/simulation/scene/rigs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace dewpoint::experiment::scenarios {
namespace {

/// Frames [begin, end) of a camera do not arrive.
struct Dropout {
  int camera = 0;
  std::int64_t begin = 0;
  std::int64_t end = 0;
};

/// One camera after another, in an order of the seed's, is away for 25 to 35 frames. With at least
/// 25 frames between two events what one does is over before the next.
bool withDropouts(ScenarioDraft& draft) {
  // Frames; chosen: 1.5 s to settle, and 2 s from one camera to the next.
  constexpr std::int64_t kFirst = 45;
  constexpr std::int64_t kApart = 60;
  const auto count = static_cast<int>(draft.rig.size());
  if (!addDeskBall(draft, kFirst + kApart * count + 15)) {
    return false;
  }
  std::vector<int> order;
  for (int camera = 0; camera < count; ++camera) {
    const auto found = order.begin() + draft.draws.drawInteger(0, camera);
    order.insert(found, camera);
  }
  std::vector<Dropout> dropouts;
  for (const int camera : order) {
    const std::int64_t begin = kFirst + kApart * static_cast<std::int64_t>(dropouts.size());
    const std::int64_t end = begin + 30 + draft.draws.drawInteger(-5, 5);
    dropouts.push_back({camera, begin, end});
    draft.events.push_back({ScenarioEvent::Kind::CameraLost, begin, camera});
    draft.events.push_back({ScenarioEvent::Kind::CameraBack, end, camera});
  }
  draft.lost = [dropouts](std::size_t camera, std::int64_t frame) {
    return std::ranges::any_of(dropouts, [&](const Dropout& dropout) {
      return dropout.camera == static_cast<int>(camera) && frame >= dropout.begin &&
             frame < dropout.end;
    });
  };
  return true;
}

/// The camera after it was moved: rotated about an axis in its image plane, so that the image
/// shifts by as much everywhere, and moved anywhere.
Camera moved(Camera camera, RandomDraws& draws) {
  // Chosen: a nudge with the elbow, 9 pixels at a focal length of 350 pixels.
  constexpr double kTurn = 1.5 * std::numbers::pi / 180.0; // radians
  constexpr double kShift = 0.01;                          // meters
  const double angle = draws.drawUniform(0.0, kFullTurn);
  const Eigen::AngleAxisd turn(kTurn, Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0));
  const Eigen::Vector3d center = camera.center() + kShift * draws.drawDirection();
  camera.cameraFromWorld.linear() = turn * camera.cameraFromWorld.linear();
  camera.cameraFromWorld.translation() = -(camera.cameraFromWorld.linear() * center);
  return camera;
}

/// The ball is in the moved camera's image as well, in every frame from `frame` on.
bool staysVisibleSince(const ScenarioDraft& draft, std::int64_t frame,
                       const simulation::RoomView& view) {
  const simulation::StageBody& ball = draft.stage.bodies[draft.targets.front()];
  for (; frame < draft.frameCount; ++frame) {
    if (!isFullyVisible(view, ball.path(draft.timeOf(frame)), ball.radius)) {
      return false;
    }
  }
  return true;
}

bool withMovedCamera(ScenarioDraft& draft) {
  constexpr int kMostPoses = 20; // that are tried; chosen, as each view is rendered
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  const std::int64_t frame = 75 + draft.draws.drawInteger(-15, 15);
  const int which = draft.draws.drawInteger(0, static_cast<int>(draft.rig.size()) - 1);
  const auto camera = static_cast<std::size_t>(which);
  for (int i = 0; i < kMostPoses; ++i) {
    // Not from the cache: no other run has this view.
    const auto view = std::make_shared<const simulation::RoomView>(
        moved(draft.rig[camera], draft.draws), *draft.room);
    if (staysVisibleSince(draft, frame, *view)) {
      // Half a frame early, so that the frame's whole exposure is after it.
      const double since = draft.timeOf(frame) - 0.5 / draft.framesPerSecond;
      draft.stage.movedCameras.push_back({camera, since, view});
      draft.events.push_back({ScenarioEvent::Kind::CameraMoved, frame, which});
      draft.isCalibrationExactWhenIdeal = false;
      return true;
    }
  }
  return false;
}

} // namespace

std::vector<ScenarioRecipe> movedCameraScenarios() {
  ScenarioRecipe recipe{"S9-bump",
                        "One of three cameras is moved by 1.5 degrees and 1 cm, and its "
                        "calibration is not corrected.",
                        threeCameraDeskRig()};
  recipe.complete = withMovedCamera;
  return {recipe};
}

std::vector<ScenarioRecipe> cameraScenarios() {
  std::vector<ScenarioRecipe> recipes;
  for (const int count : {2, 3, 4, 6, 8}) {
    ScenarioRecipe recipe{fmt::format("S6-{}", count),
                          fmt::format("The smooth path seen by {} cameras.", count),
                          deskRingRig(count)};
    recipe.complete = [](ScenarioDraft& draft) { return addDeskBall(draft, kDefaultFrameCount); };
    recipes.push_back(std::move(recipe));
  }
  ScenarioRecipe dropouts{"S6-dropouts",
                          "Each of four cameras in turn fails for about 1 s and returns.",
                          deskRingRig(4)};
  dropouts.complete = withDropouts;
  recipes.push_back(std::move(dropouts));
  return recipes;
}

} // namespace dewpoint::experiment::scenarios
