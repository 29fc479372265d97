// SPDX-License-Identifier: GPL-3.0-or-later
// S21: targets that are no balls. The truth is the centroid of what has the target's color.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/experiment/scenarios/targets/patterned_ball.h"
#include "core/simulation/body/part_shapes.h"
#include "core/simulation/body/shaped_objects.h"
#include "core/simulation/scene/rigs.h"

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <utility>

namespace dewpoint::experiment::scenarios {
namespace {

using simulation::MovingPart;
using simulation::Vector3f;

/// Pink as all balls, BGR in full light.
const Vector3f kPink = simulation::kDefaultBallColor.cast<float>();

/// What is checked around a mouse, meters: a ball as large as the mouse would go below the desk,
/// which would then hide it. All of it, half its length, is checked against the images' borders.
constexpr double kMouseBound = 0.024;
constexpr double kMouseReach = 0.06;

/// An object in its own axes at a time.
using ObjectAt = std::function<std::vector<MovingPart>(double)>;

/// How an object of a desk scene moves. Sizes are those of simulation/body/shaped_objects.cpp.
struct Handling {
  double bound = 0.1;       ///< radius of a ball around it that stays whole in all images, meters
  bool upright = false;     ///< rotates about the vertical only
  bool onDesk = false;      ///< slides on the desk
  double halfHeight = 0.02; ///< of what slides, meters
  double reach = bound;     ///< as `bound`, but only the images' borders are checked
};

ObjectAt always(std::vector<MovingPart> parts) {
  return [parts = std::move(parts)](double) { return parts; };
}

/// The glove opens and closes every 1.5 s.
std::vector<MovingPart> openingGlove(double time) {
  constexpr double kGripPeriod = 1.5; // seconds; chosen: unhurried
  return simulation::glovedHand(0.5 - 0.5 * std::cos(kFullTurn * time / kGripPeriod), kPink);
}

LissajousPath drawWay(RandomDraws& draws, const Handling& handling) {
  LissajousPath path;
  path.center = draws.drawPointInBox({0.42, 0.42, 0.22}, {0.58, 0.58, 0.32});
  path.extent = draws.drawUniform(0.7, 1.0) * Eigen::Vector3d{0.12, 0.1, 0.05};
  path.phase = draws.drawPointInBox(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(kFullTurn));
  path.periodSeconds = 6.0;
  if (handling.onDesk) {
    path.center.z() = handling.halfHeight;
    path.extent.z() = 0.0;
  }
  return path;
}

/// Whether all images show all of it all the time.
bool staysWhole(const ScenarioDraft& draft, const LissajousPath& path, const Handling& handling) {
  for (std::int64_t frame = 0; frame < draft.frameCount; ++frame) {
    const Eigen::Vector3d middle = path(draft.timeOf(frame));
    for (const auto& view : draft.stage.views) {
      if (!isWithinImage(*view, middle, handling.reach)) {
        return false;
      }
    }
  }
  return staysVisible(draft, path, handling.bound);
}

bool handled(ScenarioDraft& draft, const ObjectAt& object, const Handling& handling) {
  draft.frameCount = kDefaultFrameCount;
  RandomDraws& draws = draft.draws;
  for (int i = 0; i < kMaxDrawAttempts; ++i) {
    const LissajousPath path = drawWay(draws, handling);
    if (!staysWhole(draft, path, handling)) {
      continue;
    }
    Spin spin = randomSpin(draws, 0.05, 0.25);
    Eigen::AngleAxisd begin(draws.drawUniform(0.0, kFullTurn), draws.drawDirection());
    if (handling.upright) {
      spin.axis = Eigen::Vector3d::UnitZ();
      begin.axis() = Eigen::Vector3d::UnitZ();
    }
    addTarget(draft, path);
    draft.stage.bodies.back().parts = [object, spin,
                                       start = begin.toRotationMatrix()](double time) {
      const Eigen::Matrix3d rotation = spin.axesAt(time).transpose().cast<double>() * start;
      std::vector<MovingPart> parts = object(time);
      for (MovingPart& part : parts) {
        part = movedPart(std::move(part), rotation, Eigen::Vector3d::Zero());
      }
      return parts;
    };
    draft.isRadiusKnown = false;
    startNearTruth(draft);
    return true;
  }
  return false;
}

/// Somebody in a pink shirt who walks through the hall.
bool walking(ScenarioDraft& draft) {
  constexpr double kChest = 1.2; // meters above the floor, of somebody of kReferenceHeight
  constexpr double kBound = 0.4; // radius of a ball around the shirt, meters
  draft.frameCount = kDefaultFrameCount;
  RandomDraws& draws = draft.draws;
  simulation::Walker walker;
  walker.clothes.shirt = kPink;
  walker.height = draws.drawUniform(1.6, 1.9);
  const double chest = kChest * walker.height / simulation::kReferenceHeight;
  for (int i = 0; i < kMaxDrawAttempts; ++i) {
    walker.waypoints.clear();
    for (const double time : {-1.0, 1.5, 4.0, 7.0}) {
      const Eigen::Vector3d position = draws.drawPointInBox({-1.2, -1.0, 0.0}, {1.2, 1.4, 0.0});
      walker.waypoints.push_back({time, position.head<2>()});
    }
    const simulation::Path path = [walker, chest](double time) -> Eigen::Vector3d {
      const Eigen::Vector2d foot = walker.positionAt(time);
      return {foot.x(), foot.y(), chest};
    };
    if (!staysVisible(draft, path, kBound)) {
      continue;
    }
    addTarget(draft, path);
    draft.stage.bodies.back().parts = [walker, path](double time) {
      std::vector<MovingPart> parts = simulation::shirtOnPerson(walker, time);
      for (MovingPart& part : parts) {
        part.center -= path(time).cast<float>();
      }
      return parts;
    };
    draft.isRadiusKnown = false;
    startNearTruth(draft);
    return true;
  }
  return false;
}

} // namespace

std::vector<ScenarioRecipe> shapeScenarios() {
  const auto recipe = [](const char* name, const char* sentence, const ObjectAt& object,
                         const Handling& handling) {
    ScenarioRecipe result{name, sentence, simulation::deskRingRig(2)};
    result.complete = [object, handling](ScenarioDraft& draft) {
      return handled(draft, object, handling);
    };
    return result;
  };
  ScenarioRecipe shirt{"S21-shirt", "The shirt of a walking person.", simulation::hallRig(2),
                       simulation::Furnishing::Hall};
  shirt.complete = walking;
  return {recipe("S21-cap", "A peaked cap on a head that turns.",
                 always(simulation::capOnHead(kPink)), {0.18, true}),
          recipe("S21-hand", "A gloved hand that opens and closes.", openingGlove, {0.15}),
          recipe("S21-sleeve", "The sleeve of a forearm with a bare hand.",
                 always(simulation::sleevedArm(kPink)), {0.14}),
          recipe("S21-cone", "A cone that tumbles.", always(simulation::cone(kPink)), {0.11}),
          recipe("S21-stick", "A stick that tumbles.", always(simulation::stick(kPink)), {0.15}),
          recipe("S21-mouse", "A computer mouse on the desk.",
                 always(simulation::computerMouse(kPink)),
                 {kMouseBound, true, true, 0.02, kMouseReach}),
          shirt};
}

} // namespace dewpoint::experiment::scenarios
