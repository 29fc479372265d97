// SPDX-License-Identifier: GPL-3.0-or-later
// S11: a ball in a hand, whose fingers hide a part of it from every camera.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/experiment/scenarios/targets/hidden_share.h"
#include "core/simulation/body/hand.h"
#include "core/simulation/body/part_shapes.h"
#include "core/simulation/scene/scene.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace dewpoint::experiment::scenarios {
namespace {

using simulation::MovingPart;

/// The fingers hide this share of the disc in every camera: what fingers around a tennis ball
/// leave.
constexpr double kLeastHidden = 0.3;
constexpr double kMostHidden = 0.6;
/// The hand that comes arrives at this frame, 2 s after the start, and sets out half a second
/// before.
constexpr std::int64_t kGraspFrame = 60;
constexpr std::int64_t kReachFrame = 45;
/// How far it comes from, meters; chosen: outside of most images.
constexpr double kReachFrom = 0.4;
/// Hands that are tried around one path: about one in four hundred fits.
constexpr int kHandsPerPath = 400;

/// A hand that holds a ball, always or from kGraspFrame on. Relative to the ball's center.
struct Holding {
  std::vector<MovingPart> hand;
  Eigen::Vector3d from = Eigen::Vector3d::Zero(); ///< way from its grip to where it comes from, m
  double begin = 0.0;                             ///< seconds
  double end = 0.0;                               ///< of coming; 0: it is there from the start

  std::vector<MovingPart> at(double time) const {
    if (time >= end) {
      return hand;
    }
    const double left = 1.0 - std::clamp((time - begin) / (end - begin), 0.0, 1.0);
    const Eigen::Vector3d off = left * left * (3.0 - 2.0 * left) * from;
    std::vector<MovingPart> parts = hand;
    for (MovingPart& part : parts) {
      part.center += off.cast<float>();
    }
    return parts;
  }
};

simulation::Grip drawGrip(RandomDraws& draws) {
  /// No hand comes from below: the desk is there. Vertical component of the palm's direction;
  /// chosen.
  constexpr double kLowest = -0.3;
  simulation::Grip grip;
  do {
    grip.palm = draws.drawDirection();
  } while (grip.palm.z() < kLowest);
  grip.fingers =
      Eigen::AngleAxisd(draws.drawUniform(0.0, kFullTurn), grip.palm) * grip.palm.unitOrthogonal();
  // Radians and meters, around the usual grip, see Grip.
  grip.reachAngle = draws.drawUniform(1.4, 2.4);
  grip.spreadAngle = draws.drawUniform(0.42, 0.52);
  grip.fingerRadius = draws.drawUniform(0.008, 0.0095);
  return grip;
}

Holding holdingOf(const ScenarioDraft& draft, const simulation::Grip& grip, bool later) {
  Holding holding{simulation::grippingHand(grip, kBallRadius, simulation::kSkinColor)};
  if (later) {
    holding.from = kReachFrom * grip.forearmDirection();
    holding.begin = draft.timeOf(kReachFrame);
    holding.end = draft.timeOf(kGraspFrame);
  }
  return holding;
}

double hiddenFrom(const ScenarioDraft& draft, std::size_t camera, const Eigen::Vector3d& ball,
                  const Holding& holding, double time) {
  std::vector<MovingPart> parts = holding.at(time);
  for (MovingPart& part : parts) {
    part.center += ball.cast<float>();
  }
  return hiddenShare(draft.rig[camera].center(), ball, kBallRadius, parts);
}

/// In every camera: as much as wanted once the hand is there, and nothing before it sets out.
bool hidesAsWanted(const ScenarioDraft& draft, const LissajousPath& path, const Holding& holding,
                   bool later) {
  const auto isRight = [&](std::int64_t frame) {
    const double time = draft.timeOf(frame);
    for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
      const double hidden = hiddenFrom(draft, camera, path(time), holding, time);
      const bool held = !later || frame >= kGraspFrame;
      if (held ? hidden < kLeastHidden || hidden > kMostHidden : hidden > 0.0) {
        return false;
      }
    }
    return true;
  };
  const std::int64_t first = later ? kGraspFrame : 0;
  for (std::int64_t frame = first; frame < draft.frameCount; frame += kFractionCheckInterval) {
    if (!isRight(frame)) {
      return false;
    }
  }
  for (std::int64_t frame = 0; later && frame <= kReachFrame; frame += kFractionCheckInterval) {
    if (!isRight(frame)) {
      return false;
    }
  }
  return true;
}

bool held(ScenarioDraft& draft, bool later) {
  draft.frameCount = kDefaultFrameCount;
  for (int layout = 0; layout < kMaxLayoutAttempts; ++layout) {
    const auto path = randomDeskPath(draft, false);
    if (!path) {
      return false;
    }
    for (int i = 0; i < kHandsPerPath; ++i) {
      const Holding holding = holdingOf(draft, drawGrip(draft.draws), later);
      if (!hidesAsWanted(draft, *path, holding, later)) {
        continue;
      }
      addTarget(draft, *path);
      simulation::StageBody& ball = draft.stage.bodies.back();
      const MovingPart part = simulation::ballPart(ball.radius, ball.color.cast<float>());
      ball.nominalRadius = ball.radius;
      ball.parts = [part, holding](double time) {
        std::vector<MovingPart> parts = holding.at(time);
        parts.push_back(part);
        return parts;
      };
      startNearTruth(draft);
      return true;
    }
  }
  return false;
}

} // namespace

std::vector<ScenarioRecipe> handHeldTargetScenarios() {
  const auto recipe = [](const char* name, const char* sentence, bool later) {
    ScenarioRecipe result{name, sentence, demoRig()};
    result.complete = [later](ScenarioDraft& draft) { return held(draft, later); };
    return result;
  };
  return {recipe("S11-held",
                 "A hand holds the ball from the start; its fingers hide 30 to 60 % of the disc "
                 "in every camera.",
                 false),
          recipe("S11-grasped", "The same hand comes and holds the ball from frame 60 on.", true)};
}

} // namespace dewpoint::experiment::scenarios
