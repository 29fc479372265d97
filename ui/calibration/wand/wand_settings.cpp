// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/wand/wand_settings.h"

#include "core/project/project.h"

#include <QCoreApplication>

#include <algorithm>

namespace dewpoint::ui {
namespace {

class Words {
  Q_DECLARE_TR_FUNCTIONS(WandSettings)
};

std::optional<double> momentOf(const std::vector<TouchedMoment>& moments, TouchRole role) {
  const auto found = std::ranges::find(moments, role, &TouchedMoment::role);
  return found != moments.end() ? std::optional(found->seconds) : std::nullopt;
}

} // namespace

QString touchWords(TouchRole role) {
  switch (role) {
  case TouchRole::Floor:
    return Words::tr("touches the floor");
  case TouchRole::DistanceFrom:
    return Words::tr("is at the first end of the distance");
  case TouchRole::DistanceTo:
    return Words::tr("is at the second end of the distance");
  case TouchRole::FallBegins:
    return Words::tr("begins to fall");
  case TouchRole::FallEnds:
    break;
  }
  return Words::tr("still falls");
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

QString validationMessage(const WandSettings& wish, const std::vector<TouchedMoment>& moments,
                          const Project& project) {
  const auto balls = selectedTargets(wish, project);
  if (project.cameras.size() < 2) {
    return Words::tr("Two cameras or more must see the ball.");
  }
  if (balls.empty()) {
    return Words::tr("Learn the color of the ball first: press L and click it in an image.");
  }
  if (wish.stick && balls.size() < 2) {
    return Words::tr("A stick has two balls of different colors: learn the second one (Shift+L).");
  }
  if (wish.stick && balls[0] == balls[1]) {
    return Words::tr("The two ends of the stick are the same target: choose another.");
  }
  const bool from = momentOf(moments, TouchRole::DistanceFrom).has_value();
  const bool to = momentOf(moments, TouchRole::DistanceTo).has_value();
  if (!wish.stick && wish.size == WandSize::Distance && !(from && to)) {
    return Words::tr("The size is to come from a distance: take the moments at which the ball is "
                     "at its two ends.");
  }
  if (momentOf(moments, TouchRole::FallBegins).has_value() !=
      momentOf(moments, TouchRole::FallEnds).has_value()) {
    return Words::tr("A fall needs two moments: one at which the ball begins to fall, and one at "
                     "which it still falls.");
  }
  return {};
}

WandOptions toOptions(const WandSettings& wish, const std::vector<TouchedMoment>& moments,
                      const Project& project, const std::optional<FrameSpan>& span) {
  WandOptions options;
  options.targets = selectedTargets(wish, project);
  options.stickLength = wish.stick ? wish.length : 0.0;
  options.fromDiameter = !wish.stick && wish.size == WandSize::Diameter;
  if (!wish.stick && wish.size == WandSize::Distance) {
    options.distance =
        TouchedDistance{momentOf(moments, TouchRole::DistanceFrom).value_or(0.0),
                        momentOf(moments, TouchRole::DistanceTo).value_or(0.0), wish.distance};
  }
  for (const TouchedMoment& moment : moments) {
    if (moment.role == TouchRole::Floor) {
      options.floorTimes.push_back(moment.seconds);
    }
  }
  const auto begin = momentOf(moments, TouchRole::FallBegins);
  const auto end = momentOf(moments, TouchRole::FallEnds);
  if (begin && end) {
    options.drop = std::array<double, 2>{*begin, *end};
  }
  options.findOffsets = wish.findOffsets;
  options.findFocal = wish.findFocal;
  options.findDistortion = wish.findDistortion;
  options.roughPlace = wish.roughPlace;
  options.roughTurn = wish.roughTurn;
  if (wish.onlySpan && span) {
    options.firstFrame = span->first;
    options.endFrame = span->last + 1;
  }
  return options;
}

} // namespace dewpoint::ui
