// SPDX-License-Identifier: GPL-3.0-or-later
// S2: half of the disc hidden in one camera. S3: cameras that see nothing, and a ball that is gone.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/simulation/scene/rigs.h"
#include "core/simulation/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::experiment::scenarios {
namespace {

/// A flat plate before one camera, square to the line of sight, one edge on that line.
struct Plate {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();
  Eigen::Vector3d sight = Eigen::Vector3d::UnitX(); ///< from the eye to the target
  Eigen::Vector3d edge = Eigen::Vector3d::UnitZ();  ///< along the edge that cuts the disc
  Eigen::Vector3d aside = Eigen::Vector3d::UnitY(); ///< towards the hidden half
};

constexpr double kAlong = 0.4; // of the way from the eye to the target; chosen: one camera's alone
// Half sizes, meters; chosen: seen from the camera the plate is twice as wide as the ball and more.
constexpr double kPlateWide = 0.045;
constexpr double kPlateTall = 0.075;
constexpr double kPlateThick = 0.001;

Plate drawPlate(ScenarioDraft& draft, std::size_t camera, const Eigen::Vector3d& target) {
  Plate plate;
  plate.eye = draft.rig[camera].center();
  plate.sight = (target - plate.eye).normalized();
  const Eigen::AngleAxisd turn(draft.draws.drawUniform(0.0, kFullTurn), plate.sight);
  plate.edge = turn * plate.sight.unitOrthogonal();
  plate.aside = plate.edge.cross(plate.sight);
  return plate;
}

void addPlate(ScenarioDraft& draft, const Plate& plate, simulation::Path path) {
  simulation::StageBody& body = draft.stage.bodies.emplace_back();
  body.name = "plate";
  body.isBox = true;
  body.halfSize = {kPlateWide, kPlateTall, kPlateThick};
  body.axes.row(0) = plate.aside;
  body.axes.row(1) = plate.edge;
  body.axes.row(2) = plate.sight;
  body.color = {128.0, 132.0, 110.0};
  body.path = std::move(path);
}

/// No other camera has the plate before the target.
bool hidesNothingElse(const ScenarioDraft& draft, std::size_t camera, double from) {
  const simulation::StageBody& plate = draft.stage.bodies.back();
  const simulation::StageBody& target = draft.stage.bodies[draft.targets.front()];
  for (std::int64_t frame = 0; frame < draft.frameCount; ++frame) {
    const double time = std::max(from, draft.timeOf(frame));
    for (std::size_t other = 0; other < draft.stage.views.size(); ++other) {
      if (other != camera && !areSeparated(*draft.stage.views[other], target.path(time),
                                           kBallRadius, plate.path(time), plate.boundingRadius())) {
        return false;
      }
    }
  }
  return true;
}

/// The plate rests, and the ball moves in the plane of the eye and the plate's edge.
bool besideStillPlate(ScenarioDraft& draft) {
  const auto camera = static_cast<std::size_t>(draft.draws.drawInteger(0, 1));
  const Eigen::Vector3d center = draft.draws.drawPointInBox(kPathLow, kPathHigh);
  const Plate plate = drawPlate(draft, camera, center);
  const double period = draft.draws.drawUniform(4.0, 7.0);
  const double phase = draft.draws.drawUniform(0.0, kFullTurn);
  const simulation::Path path = [=](double time) -> Eigen::Vector3d {
    const double angle = kFullTurn * time / period + phase;
    return center + 0.08 * std::sin(angle) * plate.sight +
           0.04 * std::sin(2.0 * angle) * plate.edge;
  };
  addTarget(draft, path);
  const Eigen::Vector3d rest = plate.eye + kAlong * (center - plate.eye) + kPlateWide * plate.aside;
  addPlate(draft, plate, [rest](double) { return rest; });
  return staysVisible(draft, path, kBallRadius) && hidesNothingElse(draft, camera, 0.0);
}

/// The plate slides in from the side within seconds 0.7 to 1.3 and then stays before half of the
/// moving ball; its edge wanders by 15 % of the radius about the middle.
bool withMovingPlate(ScenarioDraft& draft) {
  // Seconds; chosen: after 20 frames without it.
  constexpr double kBegin = 0.7;
  constexpr double kEnd = 1.3;
  constexpr double kFar = 0.15;    // meters that it comes from
  constexpr double kWander = 0.15; // of the radius, see above
  const auto camera = static_cast<std::size_t>(draft.draws.drawInteger(0, 1));
  const auto path = randomDeskPath(draft, false);
  if (!path) {
    return false;
  }
  addTarget(draft, *path);
  const Plate plate = drawPlate(draft, camera, path->center);
  const double wander = draft.draws.drawUniform(1.0, 2.0);
  addPlate(draft, plate, [=, path = *path](double time) -> Eigen::Vector3d {
    const double out = std::clamp((kEnd - time) / (kEnd - kBegin), 0.0, 1.0);
    const double edge = kWander * kBallRadius * kAlong * std::sin(kFullTurn * time / wander);
    return plate.eye + kAlong * (path(time) - plate.eye) +
           (kPlateWide + kFar * out * out * (3.0 - 2.0 * out) + edge) * plate.aside;
  });
  return hidesNothingElse(draft, camera, kEnd);
}

bool halfHidden(ScenarioDraft& draft, bool (*arrange)(ScenarioDraft&)) {
  draft.frameCount = kDefaultFrameCount;
  for (int i = 0; i < kMaxDrawAttempts; ++i) {
    draft.stage.bodies.clear();
    draft.targets.clear();
    if (arrange(draft)) {
      startNearTruth(draft);
      return true;
    }
  }
  return false;
}

/// Frames [begin, end) without light in one camera; -1: in all.
struct Blackout {
  std::int64_t begin = 0;
  std::int64_t end = 0;
  int camera = -1;
};

bool withBlackouts(ScenarioDraft& draft, bool all) {
  constexpr std::int64_t kFrames = 15; // 0.5 s
  draft.frameCount = kDefaultFrameCount;
  const auto path = randomDeskPath(draft, false);
  if (!path) {
    return false;
  }
  addTarget(draft, *path);
  startNearTruth(draft);
  std::vector<Blackout> blackouts;
  const int blind = draft.draws.drawInteger(0, static_cast<int>(draft.rig.size()) - 1);
  for (const int about : {45, 110}) {
    const std::int64_t begin = about + draft.draws.drawInteger(-10, 10);
    blackouts.push_back({begin, begin + kFrames, all ? -1 : blind});
    using Kind = ScenarioEvent::Kind;
    draft.events.push_back({Kind::BlackoutBegin, begin, blackouts.back().camera});
    draft.events.push_back({Kind::BlackoutEnd, begin + kFrames, blackouts.back().camera});
  }
  const double frames = draft.framesPerSecond;
  draft.stage.light = [blackouts, frames](std::size_t camera, double time) {
    simulation::Light light;
    const std::int64_t frame = std::llround(time * frames);
    for (const Blackout& blackout : blackouts) {
      const bool here = blackout.camera < 0 || blackout.camera == static_cast<int>(camera);
      light.isDark = light.isDark || (here && frame >= blackout.begin && frame < blackout.end);
    }
    return light;
  };
  return true;
}

/// The ball is taken away and comes back on another path.
bool withAbsence(ScenarioDraft& draft) {
  draft.frameCount = kDefaultFrameCount;
  const auto before = randomDeskPath(draft, false);
  const auto after = randomDeskPath(draft, false);
  if (!before || !after) {
    return false;
  }
  const std::int64_t gone = 60 + draft.draws.drawInteger(-10, 10);
  const std::int64_t back = gone + 45 + draft.draws.drawInteger(-15, 15);
  // Half a frame early, so that no exposure holds both.
  const double goneTime = draft.timeOf(gone) - 0.5 / draft.framesPerSecond;
  const double backTime = draft.timeOf(back) - 0.5 / draft.framesPerSecond;
  addTarget(draft, [=](double time) { return time < backTime ? (*before)(time) : (*after)(time); });
  draft.stage.bodies.back().present = [=](double time) {
    return time < goneTime || time >= backTime;
  };
  draft.events.push_back({ScenarioEvent::Kind::Vanish, gone, -1});
  draft.events.push_back({ScenarioEvent::Kind::Return, back, -1});
  startNearTruth(draft);
  return true;
}

} // namespace

std::vector<ScenarioRecipe> occlusionScenarios() {
  ScenarioRecipe still{"S2-still",
                       "A fixed plate hides half of the ball in one camera; the ball moves along "
                       "the edge of the plate and in depth.",
                       demoRig()};
  still.complete = [](ScenarioDraft& draft) { return halfHidden(draft, besideStillPlate); };
  ScenarioRecipe moving{
      "S2-moving", "A plate in front of one camera follows the moving ball and hides half of it.",
      demoRig()};
  moving.complete = [](ScenarioDraft& draft) { return halfHidden(draft, withMovingPlate); };
  ScenarioRecipe third = moving;
  third.name = "S2-three-cameras";
  third.description = "The same with a third camera that sees all of the ball.";
  third.rig = threeCameraDeskRig();
  return {still, moving, third};
}

std::vector<ScenarioRecipe> blackoutScenarios() {
  const auto recipe = [](const char* name, const char* sentence, const CameraRig& rig, bool all) {
    ScenarioRecipe result{name, sentence, rig};
    result.complete = [all](ScenarioDraft& draft) { return withBlackouts(draft, all); };
    return result;
  };
  ScenarioRecipe absence{"S3-vanish", "The ball is gone for 1 to 2 s and comes back elsewhere.",
                         demoRig()};
  absence.complete = withAbsence;
  return {recipe("S3-one-blind", "One of two cameras is blind for 0.5 s, twice.", demoRig(), false),
          recipe("S3-one-blind-three-cameras", "One of three cameras is blind for 0.5 s, twice.",
                 threeCameraDeskRig(), false),
          recipe("S3-all-blind", "Both cameras are blind for 0.5 s, twice.", demoRig(), true),
          absence};
}

} // namespace dewpoint::experiment::scenarios
