// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/wand_settings.h"

#include <algorithm>

namespace dewpoint::setup {
namespace {

std::optional<double> instantOf(const std::vector<MarkedInstant>& instants, WandEvent event) {
  const auto found = std::ranges::find(instants, event, &MarkedInstant::event);
  return found != instants.end() ? std::optional(found->recordingTime) : std::nullopt;
}

} // namespace

void addInstant(std::vector<MarkedInstant>& instants, const MarkedInstant& taken) {
  std::erase_if(instants, [&](const MarkedInstant& instant) {
    return instant == taken || (taken.event != WandEvent::Floor && instant.event == taken.event);
  });
  instants.push_back(taken);
  std::ranges::stable_sort(instants, {}, &MarkedInstant::recordingTime);
}

std::vector<std::string> selectedTargets(const WandSettings& settings, const Project& project) {
  const auto known = [&](const std::string& name) {
    return std::ranges::find(project.targets, name, &Target::name) != project.targets.end();
  };
  std::vector<std::string> balls;
  if (!project.targets.empty()) {
    balls.push_back(known(settings.ballTarget) ? settings.ballTarget
                                               : project.targets.front().name);
  }
  if (settings.usesStick && project.targets.size() > 1) {
    const auto another = std::ranges::find_if(
        project.targets, [&](const Target& target) { return target.name != balls.front(); });
    balls.push_back(known(settings.secondBallTarget) ? settings.secondBallTarget : another->name);
  }
  return balls;
}

WandObstacle obstacleOf(const WandSettings& settings, const std::vector<MarkedInstant>& instants,
                        const Project& project) {
  const auto taken = [&](WandEvent event) { return instantOf(instants, event).has_value(); };
  const auto balls = selectedTargets(settings, project);
  if (project.cameras.size() < 2) {
    return WandObstacle::TooFewCameras;
  }
  if (balls.empty()) {
    return WandObstacle::NoBall;
  }
  if (settings.usesStick && balls.size() < 2) {
    return WandObstacle::NoSecondBall;
  }
  if (settings.usesStick && balls[0] == balls[1]) {
    return WandObstacle::SameBallTwice;
  }
  if (!settings.usesStick && settings.scaleSource == WandScaleSource::Distance &&
      !(taken(WandEvent::DistanceFrom) && taken(WandEvent::DistanceTo))) {
    return WandObstacle::IncompleteDistance;
  }
  return taken(WandEvent::FallBegins) != taken(WandEvent::FallEnds) ? WandObstacle::IncompleteFall
                                                                    : WandObstacle::None;
}

WandOptions toWandOptions(const WandSettings& settings, const std::vector<MarkedInstant>& instants,
                          const Project& project, const std::optional<FrameSpan>& selected) {
  WandOptions options;
  options.targets = selectedTargets(settings, project);
  options.stickLength = settings.usesStick ? settings.stickLength : 0.0;
  options.usesBallDiameter =
      !settings.usesStick && settings.scaleSource == WandScaleSource::Diameter;
  if (!settings.usesStick && settings.scaleSource == WandScaleSource::Distance) {
    options.touchedDistance = TouchedDistance{
        instantOf(instants, WandEvent::DistanceFrom).value_or(0.0),
        instantOf(instants, WandEvent::DistanceTo).value_or(0.0), settings.touchedDistance};
  }
  for (const MarkedInstant& instant : instants) {
    if (instant.event == WandEvent::Floor) {
      options.floorTimes.push_back(instant.recordingTime);
    }
  }
  const auto begin = instantOf(instants, WandEvent::FallBegins);
  const auto end = instantOf(instants, WandEvent::FallEnds);
  if (begin && end) {
    options.freeFallSpan = std::array<double, 2>{*begin, *end};
  }
  options.estimatesTimeOffsets = settings.estimatesTimeOffsets;
  options.estimatesFocalLengths = settings.estimatesFocalLengths;
  options.estimatesDistortion = settings.estimatesDistortion;
  options.initialPositionError = settings.initialPositionError;
  options.initialRotationError = settings.initialRotationError;
  if (settings.usesOnlySelectedFrames && selected) {
    options.firstFrame = selected->first;
    options.endFrame = selected->last + 1;
  }
  return options;
}

} // namespace dewpoint::setup
