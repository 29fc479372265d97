// SPDX-License-Identifier: GPL-3.0-or-later
// S18: balls that are thrown and caught, that bounce on the desk, and that spin.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/experiment/scenarios/targets/patterned_ball.h"
#include "core/experiment/scenarios/targets/piecewise_path.h"
#include "core/simulation/scene/scene.h"

#include <cmath>
#include <functional>
#include <optional>

namespace dewpoint::experiment::scenarios {
namespace {

/// Rest before the first throw or fall, seconds; chosen: methods find the ball at rest.
constexpr double kFirstRest = 0.5;

using Append = std::function<void(PiecewisePath&)>;

/// True if the ball is whole in all images from one time to another.
bool staysVisibleFrom(const ScenarioDraft& draft, const PiecewisePath& path, double begin) {
  const auto first = static_cast<std::int64_t>(std::floor(begin * draft.framesPerSecond));
  for (std::int64_t frame = first; frame < draft.frameCount; ++frame) {
    const double time = draft.timeOf(frame);
    if (time > path.endTime()) {
      return true;
    }
    if (!isFullyVisible(draft.stage, path(time), draft.ballRadius())) {
      return false;
    }
  }
  return true;
}

/// Appends pieces until the run is full; each is drawn again until it can be seen.
std::optional<PiecewisePath> drawPath(ScenarioDraft& draft, const Eigen::Vector3d& low,
                                      const Eigen::Vector3d& high, const Append& append) {
  PiecewisePath path(draft.draws.drawPointInBox(low, high));
  path.rest(kFirstRest);
  int draws = 0;
  while (path.endTime() < draft.timeOf(draft.frameCount)) {
    if (++draws > kMaxDrawAttempts || !isFullyVisible(draft.stage, path(0.0), draft.ballRadius())) {
      return std::nullopt;
    }
    PiecewisePath longer = path;
    append(longer);
    if (staysVisibleFrom(draft, longer, path.endTime())) {
      path = longer;
    }
  }
  return path;
}

/// From hand to hand: throws of 0.24 to 0.32 s, which rise by 7 to 13 cm in free flight.
std::optional<PiecewisePath> drawThrows(ScenarioDraft& draft) {
  const Eigen::Vector3d low{0.42, 0.42, 0.06};
  const Eigen::Vector3d high{0.6, 0.58, 0.1};
  return drawPath(draft, low, high, [&](PiecewisePath& path) {
    addThrow(path, draft.draws.drawPointInBox(low, high), draft.draws.drawUniform(0.24, 0.32));
    path.rest(draft.draws.drawUniform(0.15, 0.4));
  });
}

/// Dropped, bouncing until it lies, and lifted again.
std::optional<PiecewisePath> drawBounces(ScenarioDraft& draft) {
  constexpr double kLift = 0.6;  // seconds; chosen: a hand takes it up
  constexpr double kPush = 0.15; // m/s along the desk, at most; chosen: it stays in the images
  RandomDraws& draws = draft.draws;
  // Restitution of rubber balls on wood: from a dull one to a lively one.
  const double radius = draft.ballRadius();
  const Bounce bounce{radius, draws.drawUniform(0.6, 0.85)};
  const Eigen::Vector3d low{0.42, 0.42, radius + 0.1};
  const Eigen::Vector3d high{0.6, 0.58, radius + 0.17};
  return drawPath(draft, low, high, [&](PiecewisePath& path) {
    const double angle = draws.drawUniform(0.0, kFullTurn);
    const double speed = draws.drawUniform(0.0, kPush);
    path.setVelocity({speed * std::cos(angle), speed * std::sin(angle), 0.0});
    addBounces(path, bounce);
    path.rest(0.3);
    addCarry(path, draws.drawPointInBox(low, high), kLift);
    path.rest(0.2);
  });
}

using DrawPath = std::optional<PiecewisePath> (*)(ScenarioDraft&);

bool along(ScenarioDraft& draft, DrawPath drawPath) {
  draft.frameCount = kDefaultFrameCount;
  for (int layout = 0; layout < kMaxLayoutAttempts; ++layout) {
    if (const auto path = drawPath(draft)) {
      addTarget(draft, *path);
      startNearTruth(draft);
      return true;
    }
  }
  return false;
}

/// Thrown with a spin of 2 to 5 rounds per second, which a hand does not stop.
bool spinning(ScenarioDraft& draft) {
  if (!along(draft, drawThrows)) {
    return false;
  }
  const Spin spin = randomSpin(draft.draws, 2.0, 5.0);
  const BallPattern pattern = draft.draws.flipCoin() ? BallPattern::TwoPatches : BallPattern::Seams;
  paintBall(draft.stage.bodies.back(), pattern, spin, draft.draws);
  return true;
}

} // namespace

std::vector<ScenarioRecipe> thrownBallScenarios() {
  ScenarioRecipe thrown{"S18-thrown", "A ball is thrown from hand to hand (not seen) and caught.",
                        demoRig()};
  thrown.complete = [](ScenarioDraft& draft) { return along(draft, drawThrows); };
  ScenarioRecipe bouncing{"S18-bouncing",
                          "A ball falls on the desk, bounces, comes to rest, and is lifted.",
                          demoRig()};
  bouncing.complete = [](ScenarioDraft& draft) { return along(draft, drawBounces); };
  ScenarioRecipe spins{
      "S18-spinning", "The throws with a ball that has two patches or seams and spins.", demoRig()};
  spins.complete = spinning;
  return {thrown, bouncing, spins};
}

} // namespace dewpoint::experiment::scenarios
