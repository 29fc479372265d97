// SPDX-License-Identifier: GPL-3.0-or-later
// S17: balls that leave images, hover on their borders, and go behind furniture.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/targets/excursion.h"
#include "core/experiment/scenarios/targets/hidden_share.h"
#include "core/simulation/scene/rigs.h"
#include "core/simulation/scene/scene.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace dewpoint::experiment::scenarios {
namespace {

using simulation::MovingPart;

/// Ways aside that are tried from one path; chosen.
constexpr int kWaysPerPath = 400;
/// A camera is not nearer to the ball than this, meters; chosen: its image is not filled by it.
constexpr double kNearest = 0.15;

/// Above the desk, and not at a camera.
bool isFree(const ScenarioDraft& draft, const Eigen::Vector3d& position) {
  return position.z() >= kBallRadius && std::ranges::all_of(draft.rig, [&](const Camera& camera) {
           return (camera.center() - position).norm() > kNearest;
         });
}

/// Whether the ball is aside, with nothing of the way there and back.
bool isHeld(const Detour& path, double time) {
  return time >= path.holdBeginTime() && time <= path.holdEndTime();
}

/// Shown by no `leaving` camera while it is aside; whole in the others all the time.
bool leaves(const ScenarioDraft& draft, const Detour& path, const std::vector<bool>& leaving) {
  const auto isRight = [&](std::int64_t frame) {
    const double time = draft.timeOf(frame);
    const Eigen::Vector3d ball = path(time);
    if (!isFree(draft, ball)) {
      return false;
    }
    for (std::size_t camera = 0; camera < leaving.size(); ++camera) {
      const Visibility showing = visibilityOf(*draft.stage.views[camera], ball, kBallRadius);
      const bool right = leaving[camera] ? !isHeld(path, time) || showing == Visibility::None
                                         : showing == Visibility::Full;
      if (!right) {
        return false;
      }
    }
    return true;
  };
  // The middle of the hold first: most ways fail there.
  const auto middle = static_cast<std::int64_t>(
      std::lround(0.5 * (path.holdBeginTime() + path.holdEndTime()) * draft.framesPerSecond));
  if (!isRight(middle)) {
    return false;
  }
  for (std::int64_t frame = 0; frame < draft.frameCount; ++frame) {
    if (!isRight(frame)) {
      return false;
    }
  }
  return true;
}

void addLeavingTarget(ScenarioDraft& draft, const Detour& path) {
  addTarget(draft, path);
  startNearTruth(draft);
  addInvisibilityEvents(draft, [&](std::size_t camera, std::int64_t frame) {
    return visibilityOf(*draft.stage.views[camera], path(draft.timeOf(frame)),
                        draft.ballRadius()) != Visibility::None;
  });
}

/// Which cameras the ball leaves, and whether it comes back on another side.
struct Leaving {
  bool all = false;
  bool elsewhere = false;
};

std::optional<Detour> drawLeaving(ScenarioDraft& draft, const LissajousPath& base,
                                  const Leaving& leaving) {
  /// Directions of leaving and returning differ by this angle at least, radians; chosen.
  constexpr double kOtherSide = 40.0 * std::numbers::pi / 180.0;
  RandomDraws& draws = draft.draws;
  const auto last = static_cast<int>(draft.rig.size()) - 1;
  std::vector<bool> left(draft.rig.size(), leaving.all);
  if (!leaving.all) {
    left[static_cast<std::size_t>(draws.drawInteger(0, last))] = true;
  }
  for (int i = 0; i < kWaysPerPath; ++i) {
    Detour path{base};
    path.out = draws.drawUniform(0.2, 0.5) * draws.drawDirection();
    path.back = path.out;
    if (leaving.elsewhere) {
      path.back = draws.drawUniform(0.2, 0.5) * draws.drawDirection();
      if (path.back.normalized().dot(path.out.normalized()) > std::cos(kOtherSide)) {
        continue;
      }
    }
    if (leaves(draft, path, left)) {
      return path;
    }
  }
  return std::nullopt;
}

bool leave(ScenarioDraft& draft, const Leaving& leaving) {
  draft.frameCount = kDefaultFrameCount;
  for (int layout = 0; layout < kMaxLayoutAttempts; ++layout) {
    const auto base = randomDeskPath(draft, false);
    if (!base) {
      return false;
    }
    if (const auto path = drawLeaving(draft, *base, leaving)) {
      addLeavingTarget(draft, *path);
      return true;
    }
  }
  return false;
}

/// A small round path in the middle of the desk.
LissajousPath drawSmallPath(RandomDraws& draws, const Eigen::Vector3d& low,
                            const Eigen::Vector3d& high, const Eigen::Vector3d& extent) {
  LissajousPath path;
  path.center = draws.drawPointInBox(low, high);
  path.extent = draws.drawUniform(0.7, 1.0) * extent;
  path.phase = draws.drawPointInBox(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(kFullTurn));
  path.periodSeconds = draws.drawUniform(4.0, 6.0);
  return path;
}

/// The way from `center` along `direction` to the border of a camera's image; nothing if it is
/// longer than half a meter.
std::optional<Eigen::Vector3d> wayToBorder(const simulation::RoomView& view,
                                           const Eigen::Vector3d& center,
                                           const Eigen::Vector3d& direction) {
  constexpr double kMost = 0.5; // meters; chosen: farther off is the room's clutter
  constexpr int kHalvings = 30; // to a billionth of kMost
  const auto isInside = [&](double length) {
    const auto pixel = view.projector.project(center + length * direction);
    return pixel && pixel->x() >= 0.0 && pixel->y() >= 0.0 && pixel->x() <= view.width - 1.0 &&
           pixel->y() <= view.height - 1.0;
  };
  double inside = 0.0;
  double outside = kMost;
  if (!isInside(inside) || isInside(outside)) {
    return std::nullopt;
  }
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (inside + outside);
    (isInside(middle) ? inside : outside) = middle;
  }
  return inside * direction;
}

/// The ball goes to the border of one image and hovers there, partly outside, for three seconds.
bool hoverOnBorder(ScenarioDraft& draft) {
  draft.frameCount = kDefaultFrameCount;
  RandomDraws& draws = draft.draws;
  const double radius = draft.ballRadius();
  // Smaller than the ball, so that a part of it stays in the image.
  const Eigen::Vector3d extent = draft.radiusScale * Eigen::Vector3d{0.02, 0.02, 0.015};
  for (int i = 0; i < kMaxDrawAttempts; ++i) {
    Detour path{drawSmallPath(draws, kPathLow, kPathHigh, extent)};
    path.beginTime = 0.7;
    path.holdSeconds = 3.0;
    const auto camera =
        static_cast<std::size_t>(draws.drawInteger(0, static_cast<int>(draft.rig.size()) - 1));
    const int axis = draws.drawInteger(0, 1); // to the side, or up or down
    const double side = draws.flipCoin() ? 1.0 : -1.0;
    const Eigen::Vector3d direction =
        side * draft.rig[camera].cameraFromWorld.linear().row(axis).transpose();
    const auto way = wayToBorder(*draft.stage.views[camera], path.basePath.center, direction);
    if (!way) {
      continue;
    }
    path.out = *way;
    path.back = *way;
    bool right = true;
    for (std::int64_t frame = 0; right && frame < draft.frameCount; ++frame) {
      const double time = draft.timeOf(frame);
      const Eigen::Vector3d ball = path(time);
      right = isFree(draft, ball);
      for (std::size_t other = 0; right && other < draft.rig.size(); ++other) {
        const Visibility showing = visibilityOf(*draft.stage.views[other], ball, radius);
        right = other == camera ? showing != Visibility::None &&
                                      (time > path.beginTime || showing == Visibility::Full)
                                : showing == Visibility::Full;
      }
    }
    if (right) {
      addLeavingTarget(draft, path);
      return true;
    }
  }
  return false;
}

/// A box that stands on the desk before a point as a camera sees it.
simulation::StageBody drawScreen(RandomDraws& draws, const Eigen::Vector3d& eye,
                                 const Eigen::Vector3d& point, std::size_t number) {
  constexpr double kAbove = 0.09; // of its top above the line of sight, meters: 2.5 radii
  const Eigen::Vector3d onSight = eye + draws.drawUniform(0.6, 0.72) * (point - eye);
  const double halfHeight = 0.5 * (onSight.z() + kAbove);
  Eigen::Vector3d towards = point - eye;
  towards.z() = 0.0;
  towards.normalize();
  simulation::StageBody box;
  box.name = fmt::format("box {}", number);
  box.isBox = true;
  box.halfSize = {0.03, draws.drawUniform(0.08, 0.1), halfHeight};
  box.axes.row(0) = towards;
  box.axes.row(1) = Eigen::Vector3d::UnitZ().cross(towards);
  box.axes.row(2) = Eigen::Vector3d::UnitZ();
  box.color = {72.0, 112.0, 150.0};
  const Eigen::Vector3d center{onSight.x(), onSight.y(), halfHeight};
  box.path = [center](double) { return center; };
  return box;
}

/// True if a ball is clear of a box.
bool isClear(const simulation::StageBody& box, const Eigen::Vector3d& ball) {
  const Eigen::Vector3d beyond =
      ((box.axes * (ball - box.path(0.0))).cwiseAbs() - box.halfSize).cwiseMax(0.0);
  return beyond.norm() > kBallRadius;
}

/// Share of the ball that boxes hide from a camera; nothing if the painter, who goes by the
/// distances of centers, would take one that is behind for one that is before or the reverse.
std::optional<double> hiddenBy(const std::vector<simulation::StageBody>& boxes,
                               const Eigen::Vector3d& eye, const Eigen::Vector3d& ball) {
  std::vector<MovingPart> parts;
  for (const simulation::StageBody& box : boxes) {
    parts.push_back(boxPart(box));
    const double hidden = hiddenShare(eye, ball, kBallRadius, {parts.back()});
    const double backed = overlappedFraction(eye, ball, kBallRadius, {parts.back()});
    const bool nearer = (box.path(0.0) - eye).norm() < (ball - eye).norm();
    if (hidden != (nearer ? backed : 0.0)) {
      return std::nullopt;
    }
  }
  return hiddenShare(eye, ball, kBallRadius, parts);
}

/// Free of the boxes, whole in every image before and after, and hidden in every image while it is
/// aside.
bool goesBehind(const ScenarioDraft& draft, const Detour& path,
                const std::vector<simulation::StageBody>& boxes) {
  for (std::int64_t frame = 0; frame < draft.frameCount; ++frame) {
    const double time = draft.timeOf(frame);
    const Eigen::Vector3d ball = path(time);
    if (!isFree(draft, ball) || !isFullyVisible(draft.stage, ball, kBallRadius) ||
        !std::ranges::all_of(boxes, [&](const auto& box) { return isClear(box, ball); })) {
      return false;
    }
    for (const Camera& camera : draft.rig) {
      const auto hidden = hiddenBy(boxes, camera.center(), ball);
      const bool outside = time <= path.beginTime || time >= path.endTime();
      if (!hidden || (outside && *hidden > 0.0) || (isHeld(path, time) && *hidden < 1.0)) {
        return false;
      }
    }
  }
  return true;
}

bool behindFurniture(ScenarioDraft& draft) {
  draft.frameCount = kDefaultFrameCount;
  RandomDraws& draws = draft.draws;
  for (int i = 0; i < kMaxDrawAttempts; ++i) {
    Detour path{drawSmallPath(draws, {0.4, 0.4, 0.1}, {0.6, 0.6, 0.16}, {0.03, 0.03, 0.02})};
    const double angle = draws.drawUniform(0.0, kFullTurn);
    path.out =
        draws.drawUniform(0.25, 0.4) * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
    path.back = path.out;
    std::vector<simulation::StageBody> boxes;
    for (const Camera& camera : draft.rig) {
      boxes.push_back(
          drawScreen(draws, camera.center(), path.basePath.center + path.out, boxes.size() + 1));
    }
    if (!goesBehind(draft, path, boxes)) {
      continue;
    }
    addTarget(draft, path);
    startNearTruth(draft);
    addInvisibilityEvents(draft, [&](std::size_t camera, std::int64_t frame) {
      const auto hidden = hiddenBy(boxes, draft.rig[camera].center(), path(draft.timeOf(frame)));
      return hidden && *hidden < 1.0;
    });
    for (simulation::StageBody& box : boxes) {
      draft.stage.bodies.push_back(std::move(box));
    }
    return true;
  }
  return false;
}

} // namespace

std::vector<ScenarioRecipe> outOfViewScenarios() {
  const auto recipe = [](const char* name, const char* sentence, const Leaving& leaving) {
    ScenarioRecipe result{name, sentence, demoRig()};
    result.complete = [leaving](ScenarioDraft& draft) { return leave(draft, leaving); };
    return result;
  };
  ScenarioRecipe border{"S17-border", "The ball hovers on the border of one image for 3 s.",
                        demoRig()};
  border.complete = hoverOnBorder;
  ScenarioRecipe furniture{"S17-furniture",
                           "The ball goes behind boxes on the desk, which hide it from all "
                           "cameras for 1.2 s.",
                           deskRingRig(2)};
  furniture.complete = behindFurniture;
  return {recipe("S17-leaves-one", "The ball leaves one image for 1.2 s and comes back.", {}),
          recipe("S17-leaves-all", "The ball leaves all images for 1.2 s and comes back.",
                 {true, false}),
          recipe("S17-returns-elsewhere", "The same, but it comes back from another side.",
                 {true, true}),
          border, furniture};
}

} // namespace dewpoint::experiment::scenarios
