// SPDX-License-Identifier: GPL-3.0-or-later
// S4: searches that start anywhere, and targets that jump.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/simulation/scene/rigs.h"
#include "core/simulation/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

namespace dewpoint::experiment::scenarios {
namespace {

/// A volume that a target may be anywhere in.
struct Volume {
  Eigen::Vector3d low;
  Eigen::Vector3d high;
  double radius = kBallRadius; ///< of the target, meters
  double nearest = 0.25;       ///< no thing of the target's color is nearer to a camera, meters
  double drift = 0.2;          ///< the target's greatest speed, m/s
  Eigen::Vector3d center() const { return 0.5 * (low + high); }
  Eigen::Vector3d half() const { return 0.5 * (high - low); }
};

// Chosen: all of the desk with the air above it, and all of a living room.
const Volume kDesk{{0.0, 0.0, 0.0}, {1.0, 1.0, 0.5}, kBallRadius, 0.25, 0.2};
const Volume kHall{{-2.0, -2.0, 0.0}, {2.0, 2.0, 2.0}, simulation::kHallBallRadius, 1.0, 0.5};

bool farFromCameras(const simulation::Stage& stage, const Volume& volume,
                    const Eigen::Vector3d& position) {
  return std::ranges::all_of(stage.views, [&](const auto& view) {
    return (view->center.template cast<double>() - position).norm() >= volume.nearest;
  });
}

/// A place in the volume that all cameras see.
std::optional<Eigen::Vector3d> drawPosition(ScenarioDraft& draft, const Volume& volume) {
  const Eigen::Vector3d up = volume.radius * Eigen::Vector3d::UnitZ();
  for (int i = 0; i < kMaxDrawAttempts; ++i) {
    const Eigen::Vector3d position = draft.draws.drawPointInBox(volume.low + up, volume.high);
    if (farFromCameras(draft.stage, volume, position) &&
        isFullyVisible(draft.stage, position, volume.radius)) {
      return position;
    }
  }
  return std::nullopt;
}

/// A slow straight way that begins anywhere in the volume.
std::optional<simulation::Path> drawWay(ScenarioDraft& draft, const Volume& volume) {
  for (int i = 0; i < kMaxDrawAttempts; ++i) {
    const auto position = drawPosition(draft, volume);
    if (!position) {
      return std::nullopt;
    }
    const Eigen::Vector3d speed =
        draft.draws.drawUniform(0.0, volume.drift) * draft.draws.drawDirection();
    const simulation::Path way = [=](double time) -> Eigen::Vector3d {
      return *position + time * speed;
    };
    if (staysVisible(draft, way, volume.radius)) {
      return way;
    }
  }
  return std::nullopt;
}

enum class Distractor { SmallBall, BigBall, SmallBox, BigBox, Patch };

/// The target's color, but another physical size (0.5 to 0.7 or 1.6 to 2 times) or shape.
simulation::StageBody drawDistractor(RandomDraws& draws, Distractor kind, double radius) {
  simulation::StageBody body;
  const double small = draws.drawUniform(0.5, 0.7) * radius;
  const double big = draws.drawUniform(1.6, 2.0) * radius;
  const double other = draws.drawUniform(1.6, 2.4) * radius;
  const Eigen::AngleAxisd yaw(draws.drawUniform(0.0, kFullTurn), Eigen::Vector3d::UnitZ());
  switch (kind) {
  case Distractor::SmallBall:
    body.radius = small;
    return body;
  case Distractor::BigBall:
    body.radius = big;
    return body;
  case Distractor::SmallBox:
    body.halfSize = {0.8 * small, 0.8 * small, 0.8 * small};
    break;
  case Distractor::BigBox:
    body.halfSize = {big, 0.8 * big, 0.9 * big};
    break;
  case Distractor::Patch:
    body.halfSize = {big, other, 0.02 * radius};
    break;
  }
  body.isBox = true;
  body.axes = yaw.toRotationMatrix().transpose();
  if (kind == Distractor::Patch && draws.flipCoin()) {
    // Upright like a poster instead of flat like a sheet.
    body.axes = (yaw * Eigen::AngleAxisd(0.5 * std::numbers::pi, Eigen::Vector3d::UnitX()))
                    .toRotationMatrix()
                    .transpose();
  }
  return body;
}

/// Where a distractor may be: not near the target, not before or beside it in any image, seen by
/// at least `cameras` cameras.
bool isPossible(const ScenarioDraft& draft, const Volume& volume, const simulation::StageBody& body,
                const Eigen::Vector3d& position, int cameras) {
  constexpr double kGap = 0.01; // radians: about 3 pixels; chosen: blobs do not touch
  const simulation::Path& target = draft.stage.bodies[draft.targets.front()].path;
  const double last = draft.timeOf(draft.frameCount - 1);
  int seen = 0;
  for (const auto& view : draft.stage.views) {
    for (const double time : {0.0, 0.5 * last, last}) {
      if ((target(time) - position).norm() < 3.0 * volume.radius + body.boundingRadius() ||
          !areSeparated(*view, target(time), volume.radius, position, body.boundingRadius(),
                        kGap)) {
        return false;
      }
    }
    seen += isFullyVisible(*view, position, body.boundingRadius()) ? 1 : 0;
  }
  return seen >= cameras && farFromCameras(draft.stage, volume, position);
}

bool addDistractors(ScenarioDraft& draft, const Volume& volume) {
  std::array<Distractor, 5> kinds{Distractor::SmallBall, Distractor::BigBall, Distractor::SmallBox,
                                  Distractor::BigBox, Distractor::Patch};
  for (int count = 0; count < 3; ++count) {
    const auto first = static_cast<std::size_t>(count);
    std::swap(kinds[first], kinds[static_cast<std::size_t>(draft.draws.drawInteger(count, 4))]);
    simulation::StageBody body = drawDistractor(draft.draws, kinds[first], volume.radius);
    body.name = fmt::format("look-alike {}", count + 1);
    const int cameras = count == 0 ? 2 : 1;
    bool placed = false;
    for (int i = 0; i < kMaxDrawAttempts / 10 && !placed; ++i) {
      Eigen::Vector3d position = draft.draws.drawPointInBox(volume.low, volume.high);
      if (draft.draws.flipCoin()) {
        position.z() = 0.0; // on the ground: that high is half of what stands on it
      }
      position.z() = std::max(position.z(), body.isBox ? body.halfSize.z() : body.radius);
      placed = isPossible(draft, volume, body, position, cameras);
      if (placed) {
        body.path = [position](double) { return position; };
        draft.stage.bodies.push_back(body);
      }
    }
    if (!placed) {
      return false;
    }
  }
  return true;
}

bool startAnywhere(ScenarioDraft& draft, const Volume& volume, bool cloud) {
  draft.frameCount = 10;
  for (int i = 0; i < kMaxLayoutAttempts; ++i) {
    draft.stage.bodies.clear();
    draft.targets.clear();
    const auto way = drawWay(draft, volume);
    if (!way) {
      return false;
    }
    addTarget(draft, *way, volume.radius);
    if (!addDistractors(draft, volume)) {
      continue;
    }
    draft.startCenter =
        cloud ? volume.center() : draft.draws.drawPointInBox(volume.low, volume.high);
    draft.startHalfSize = cloud ? volume.half() : Eigen::Vector3d::Zero();
    return true;
  }
  return false;
}

bool jumpBy(ScenarioDraft& draft, const Volume& volume, double length) {
  constexpr std::int64_t kJumpFrame = 30; // chosen: a second, in which methods have found it
  draft.frameCount = 60;
  for (int i = 0; i < kMaxDrawAttempts; ++i) {
    const auto from = drawPosition(draft, volume);
    if (!from) {
      return false;
    }
    const Eigen::Vector3d to = *from + length * draft.draws.drawDirection();
    const bool inside = (to.array() >= volume.low.array()).all() &&
                        (to.array() <= volume.high.array()).all() && to.z() >= volume.radius;
    if (!inside || !farFromCameras(draft.stage, volume, to) ||
        !isFullyVisible(draft.stage, to, volume.radius)) {
      continue;
    }
    // Half a frame early, so that no exposure holds the ball at two places.
    const double when = draft.timeOf(kJumpFrame) - 0.5 / draft.framesPerSecond;
    addTarget(
        draft, [from = *from, to, when](double time) { return time < when ? from : to; },
        volume.radius);
    draft.events.push_back({ScenarioEvent::Kind::Jump, kJumpFrame, -1});
    startNearTruth(draft);
    return true;
  }
  return false;
}

} // namespace

std::vector<ScenarioRecipe> startScenarios() {
  const auto recipe = [](const char* name, const char* sentence, bool hall, auto complete) {
    ScenarioRecipe result{name, sentence, hall ? hallRig(2) : demoRig()};
    if (hall) {
      result.furnishing = simulation::Furnishing::Hall;
    }
    const Volume& volume = hall ? kHall : kDesk;
    result.complete = [volume, complete](ScenarioDraft& draft) { return complete(draft, volume); };
    return result;
  };
  const auto cloud = [](ScenarioDraft& draft, const Volume& volume) {
    return startAnywhere(draft, volume, true);
  };
  const auto point = [](ScenarioDraft& draft, const Volume& volume) {
    return startAnywhere(draft, volume, false);
  };
  return {
      recipe("S4-desk-cloud", "The search starts all over the desk, 1 x 1 x 0.5 m.", false, cloud),
      recipe("S4-desk-point", "The search starts at one random point of the desk.", false, point),
      recipe("S4-room-cloud", "The search starts all over a room of 4 x 4 x 2 m.", true, cloud),
      recipe("S4-room-point", "The search starts at one random point of the room.", true, point),
      recipe(
          "S4-jump-desk", "The ball jumps by 0.355 m after 30 frames.", false,
          [](ScenarioDraft& draft, const Volume& volume) { return jumpBy(draft, volume, 0.355); }),
      recipe(
          "S4-jump-room", "The ball jumps by 2 m after 30 frames.", true,
          [](ScenarioDraft& draft, const Volume& volume) { return jumpBy(draft, volume, 2.0); })};
}

} // namespace dewpoint::experiment::scenarios
