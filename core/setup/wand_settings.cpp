// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/wand_settings.h"

#include <algorithm>

namespace dewpoint::setup {
namespace {

std::optional<double> instantOf(const std::vector<TouchedInstant>& instants, TouchRole role) {
  const auto found = std::ranges::find(instants, role, &TouchedInstant::role);
  return found != instants.end() ? std::optional(found->seconds) : std::nullopt;
}

} // namespace

void addInstant(std::vector<TouchedInstant>& instants, const TouchedInstant& taken) {
  std::erase_if(instants, [&](const TouchedInstant& instant) {
    return instant == taken || (taken.role != TouchRole::Floor && instant.role == taken.role);
  });
  instants.push_back(taken);
  std::ranges::stable_sort(instants, {}, &TouchedInstant::seconds);
}

std::vector<std::string> selectedTargets(const WandSettings& wish, const Project& project) {
  const auto known = [&](const std::string& name) {
    return std::ranges::find(project.targets, name, &Target::name) != project.targets.end();
  };
  std::vector<std::string> balls;
  if (!project.targets.empty()) {
    balls.push_back(known(wish.ball) ? wish.ball : project.targets.front().name);
  }
  if (wish.stick && project.targets.size() > 1) {
    const auto another = std::ranges::find_if(
        project.targets, [&](const Target& target) { return target.name != balls.front(); });
    balls.push_back(known(wish.other) ? wish.other : another->name);
  }
  return balls;
}

WandObstacle obstacleOf(const WandSettings& wish, const std::vector<TouchedInstant>& instants,
                        const Project& project) {
  const auto taken = [&](TouchRole role) { return instantOf(instants, role).has_value(); };
  const auto balls = selectedTargets(wish, project);
  if (project.cameras.size() < 2) {
    return WandObstacle::TooFewCameras;
  }
  if (balls.empty()) {
    return WandObstacle::NoBall;
  }
  if (wish.stick && balls.size() < 2) {
    return WandObstacle::NoSecondBall;
  }
  if (wish.stick && balls[0] == balls[1]) {
    return WandObstacle::SameBallTwice;
  }
  if (!wish.stick && wish.size == WandSize::Distance &&
      !(taken(TouchRole::DistanceFrom) && taken(TouchRole::DistanceTo))) {
    return WandObstacle::DistanceNotTaken;
  }
  return taken(TouchRole::FallBegins) != taken(TouchRole::FallEnds) ? WandObstacle::HalfAFall
                                                                    : WandObstacle::None;
}

WandOptions toOptions(const WandSettings& wish, const std::vector<TouchedInstant>& instants,
                      const Project& project, const std::optional<FrameStretch>& selected) {
  WandOptions options;
  options.targets = selectedTargets(wish, project);
  options.stickLength = wish.stick ? wish.length : 0.0;
  options.fromDiameter = !wish.stick && wish.size == WandSize::Diameter;
  if (!wish.stick && wish.size == WandSize::Distance) {
    options.distance =
        TouchedDistance{instantOf(instants, TouchRole::DistanceFrom).value_or(0.0),
                        instantOf(instants, TouchRole::DistanceTo).value_or(0.0), wish.distance};
  }
  for (const TouchedInstant& instant : instants) {
    if (instant.role == TouchRole::Floor) {
      options.floorTimes.push_back(instant.seconds);
    }
  }
  const auto begin = instantOf(instants, TouchRole::FallBegins);
  const auto end = instantOf(instants, TouchRole::FallEnds);
  if (begin && end) {
    options.drop = std::array<double, 2>{*begin, *end};
  }
  options.findOffsets = wish.findOffsets;
  options.findFocal = wish.findFocal;
  options.findDistortion = wish.findDistortion;
  options.initialPositionError = wish.initialPositionError;
  options.initialTurnError = wish.initialTurnError;
  if (wish.onlySpan && selected) {
    options.firstFrame = selected->first;
    options.endFrame = selected->last + 1;
  }
  return options;
}

} // namespace dewpoint::setup
