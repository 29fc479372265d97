// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/wand_views.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// What gives a calibration by wand its size.
enum class WandSize { Cameras, Diameter, Distance };

/// The user's choices for a calibration by wand: kept as it was typed, whether or not
/// it makes sense yet.
struct WandSettings {
  bool stick = false;                ///< two balls; else one
  std::string ball;                  ///< names of targets; empty: the first ones
  std::string other;                 ///< the other end of the stick
  double length = 0.5;               ///< of the stick, between the balls' middles; meters
  WandSize size = WandSize::Cameras; ///< with one ball
  double distance = 1.0;             ///< between the two positions touched; meters
  bool findOffsets = false;
  bool findFocal = false;
  bool findDistortion = false;
  bool onlySpan = false; ///< search only the frames that are selected
  double initialPositionError = WandOptions().initialPositionError; ///< meters
  double initialTurnError = WandOptions().initialTurnError;         ///< radians

  bool operator==(const WandSettings&) const = default;
};

/// What the ball did at an instant.
enum class TouchRole { Floor, DistanceFrom, DistanceTo, FallBegins, FallEnds };
constexpr int kTouchRoles = 5;

struct TouchedInstant {
  std::int64_t frame = 0;
  double seconds = 0.0;
  TouchRole role = TouchRole::Floor;

  bool operator==(const TouchedInstant&) const = default;
};

/// Adds an instant: the floor may be touched often, each of the others happens once, and what was
/// recorded for it before is replaced. Ascending in time.
void addInstant(std::vector<TouchedInstant>& instants, const TouchedInstant& taken);

/// The names of the balls: as in the settings, or the project's first targets. A stick has two, as
/// far as the project has as many targets.
std::vector<std::string> selectedTargets(const WandSettings& settings, const Project& project);

/// What prevents a calibration with some settings.
enum class WandObstacle {
  None,
  TooFewCameras,    ///< a single camera measures no size
  NoBall,           ///< the project has no target
  NoSecondBall,     ///< a stick, and one target
  SameBallTwice,    ///< both ends of the stick are the same target
  DistanceNotTaken, ///< the size is to come from a distance whose ends were not both touched
  HalfAFall         ///< only one end of a fall is known
};
/// The first one, in this order.
WandObstacle obstacleOf(const WandSettings& settings, const std::vector<TouchedInstant>& instants,
                        const Project& project);

/// Frames from the first to the last, both included.
struct FrameStretch {
  std::int64_t first = 0;
  std::int64_t last = 0;
};

/// The options for settings without an obstacle. `selected`: the frames for WandSettings::onlySpan.
WandOptions toOptions(const WandSettings& settings, const std::vector<TouchedInstant>& instants,
                      const Project& project, const std::optional<FrameStretch>& selected = {});

} // namespace dewpoint::setup
