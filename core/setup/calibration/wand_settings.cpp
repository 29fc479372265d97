// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/wand_settings.h"

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

std::vector<std::string> selectedTargets(const WandSettings& settings, const Project& project) {
  const auto known = [&](const std::string& name) {
    return std::ranges::find(project.targets, name, &Target::name) != project.targets.end();
  };
  std::vector<std::string> balls;
  if (!project.targets.empty()) {
    balls.push_back(known(settings.ball) ? settings.ball : project.targets.front().name);
  }
  if (settings.stick && project.targets.size() > 1) {
    const auto another = std::ranges::find_if(
        project.targets, [&](const Target& target) { return target.name != balls.front(); });
    balls.push_back(known(settings.other) ? settings.other : another->name);
  }
  return balls;
}

WandObstacle obstacleOf(const WandSettings& settings, const std::vector<TouchedInstant>& instants,
                        const Project& project) {
  const auto taken = [&](TouchRole role) { return instantOf(instants, role).has_value(); };
  const auto balls = selectedTargets(settings, project);
  if (project.cameras.size() < 2) {
    return WandObstacle::TooFewCameras;
  }
  if (balls.empty()) {
    return WandObstacle::NoBall;
  }
  if (settings.stick && balls.size() < 2) {
    return WandObstacle::NoSecondBall;
  }
  if (settings.stick && balls[0] == balls[1]) {
    return WandObstacle::SameBallTwice;
  }
  if (!settings.stick && settings.size == WandSize::Distance &&
      !(taken(TouchRole::DistanceFrom) && taken(TouchRole::DistanceTo))) {
    return WandObstacle::DistanceNotTaken;
  }
  return taken(TouchRole::FallBegins) != taken(TouchRole::FallEnds) ? WandObstacle::HalfAFall
                                                                    : WandObstacle::None;
}

WandOptions toOptions(const WandSettings& settings, const std::vector<TouchedInstant>& instants,
                      const Project& project, const std::optional<FrameStretch>& selected) {
  WandOptions options;
  options.targets = selectedTargets(settings, project);
  options.stickLength = settings.stick ? settings.length : 0.0;
  options.fromDiameter = !settings.stick && settings.size == WandSize::Diameter;
  if (!settings.stick && settings.size == WandSize::Distance) {
    options.distance = TouchedDistance{instantOf(instants, TouchRole::DistanceFrom).value_or(0.0),
                                       instantOf(instants, TouchRole::DistanceTo).value_or(0.0),
                                       settings.distance};
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
  options.findOffsets = settings.findOffsets;
  options.findFocal = settings.findFocal;
  options.findDistortion = settings.findDistortion;
  options.initialPositionError = settings.initialPositionError;
  options.initialTurnError = settings.initialTurnError;
  if (settings.onlySpan && selected) {
    options.firstFrame = selected->first;
    options.endFrame = selected->last + 1;
  }
  return options;
}

} // namespace dewpoint::setup
