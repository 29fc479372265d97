// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/wand_refinement.h"
#include "ui/selection/selection.h"

#include <QString>

#include <optional>
#include <vector>

namespace dewpoint::ui {

/// What gives a calibration from a waved target its size.
enum class WandSize { Cameras, Diameter, Distance };

/// What a person decides on the page: kept as it was typed, whether or not it makes sense yet.
struct WandSettings {
  bool stick = false;                ///< two balls; else one
  std::string ball;                  ///< names of targets; empty: the first ones
  std::string other;                 ///< the other end of the stick
  double length = 0.5;               ///< of the stick, between the balls' middles; metres
  WandSize size = WandSize::Cameras; ///< with one ball
  double distance = 1.0;             ///< between the two places touched; metres
  bool findOffsets = false;
  bool findFocal = false;
  bool findDistortion = false;
  bool onlySpan = false; ///< look through the span selected in the timeline only
  double roughPlace = WandOptions().roughPlace; ///< metres
  double roughTurn = WandOptions().roughTurn;   ///< radians

  bool operator==(const WandSettings&) const = default;
};

/// What the ball did at a moment.
enum class TouchRole { Floor, DistanceFrom, DistanceTo, FallBegins, FallEnds };
constexpr int kTouchRoles = 5;

struct TouchedMoment {
  qint64 frame = 0;
  double seconds = 0.0;
  TouchRole role = TouchRole::Floor;

  bool operator==(const TouchedMoment&) const = default;
};

/// In a person's words: "touches the floor".
QString touchWords(TouchRole role);

/// The names of the balls: as wished, or the project's first targets.
std::vector<std::string> selectedTargets(const WandSettings& wish, const Project& project);

/// What keeps the wish from being fulfilled, as a sentence; empty when nothing does.
QString validationMessage(const WandSettings& wish, const std::vector<TouchedMoment>& moments,
                          const Project& project);

/// The options of core/session for a wish that misses nothing.
WandOptions toOptions(const WandSettings& wish, const std::vector<TouchedMoment>& moments,
                      const Project& project, const std::optional<FrameSpan>& span);

} // namespace dewpoint::ui
