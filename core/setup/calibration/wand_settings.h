// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/wand_views.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Source of the scale of a wand calibration.
enum class WandScaleSource {
  Cameras,  ///< the camera positions in the project
  Diameter, ///< the diameter of the ball
  Distance  ///< a measured distance between two positions that are touched with the ball
};

/// The user's choices for a calibration with a wand (a colored ball, or a stick with two balls,
/// that is waved), as entered. They may not be valid yet.
struct WandSettings {
  bool usesStick = false; ///< true: two balls on a stick; false: one ball
  std::string
      ballTarget; ///< name of the target that is the ball; empty: the project's first target
  /// Name of the target at the other end of the stick; empty: the first target that is not
  /// `ballTarget`.
  std::string secondBallTarget;
  double stickLength = 0.5; ///< distance between the centers of the balls on the stick, meters
  WandScaleSource scaleSource =
      WandScaleSource::Cameras; ///< source of the scale if the wand is one ball
  /// For WandScaleSource::Distance: distance between the two touched positions, meters.
  double touchedDistance = 1.0;
  bool estimatesTimeOffsets = false;
  bool estimatesFocalLengths = false;
  bool estimatesDistortion = false;
  bool usesOnlySelectedFrames = false; ///< true to search only the frames that the user selected
  /// Possible error of the project's camera positions, meters.
  double initialPositionError = WandOptions().initialPositionError;
  /// Possible error of the project's camera orientations, radians.
  double initialRotationError = WandOptions().initialRotationError;

  bool operator==(const WandSettings&) const = default;
};

/// Event that the user marks in a recording: something that happens to the ball of the wand.
enum class WandEvent { Floor, DistanceFrom, DistanceTo, FallBegins, FallEnds };
constexpr int kWandEventCount = 5;

/// Time marked by the user, and the event at this time. `recordingTime` is the time in the
/// recording, in seconds.
struct MarkedInstant {
  std::int64_t frame = 0;
  double recordingTime = 0.0;
  WandEvent event = WandEvent::Floor;

  bool operator==(const MarkedInstant&) const = default;
};

/// Inserts the marked time `taken` into `instants`, which is in ascending order of time. The floor
/// may be touched several times. Each other event occurs only once, so a new mark replaces the
/// earlier one.
void addInstant(std::vector<MarkedInstant>& instants, const MarkedInstant& taken);

/// Returns the names of the targets that are the balls of the wand: those in the settings, or the
/// project's first targets. Returns two names for a stick, if the project has enough targets.
std::vector<std::string> selectedTargets(const WandSettings& settings, const Project& project);

/// Reason why a calibration with these settings is not possible.
enum class WandObstacle {
  None,
  TooFewCameras,      ///< a single camera cannot determine the scale
  NoBall,             ///< the project has no target
  NoSecondBall,       ///< a stick needs two targets, but there is only one
  SameBallTwice,      ///< both ends of the stick are the same target
  IncompleteDistance, ///< the scale is to come from a distance, but not both ends were touched
  IncompleteFall      ///< only one end of a fall is marked
};
/// Returns the first obstacle that prevents a calibration with these settings, in the order of the
/// enumeration; None if there is no obstacle.
WandObstacle obstacleOf(const WandSettings& settings, const std::vector<MarkedInstant>& instants,
                        const Project& project);

/// Frames from the first to the last, both included.
struct FrameSpan {
  std::int64_t first = 0;
  std::int64_t last = 0;
};

/// Converts the user's settings for a wand calibration to options. obstacleOf() must return None
/// for these settings. `selected` are the frames for WandSettings::usesOnlySelectedFrames.
WandOptions toWandOptions(const WandSettings& settings, const std::vector<MarkedInstant>& instants,
                          const Project& project, const std::optional<FrameSpan>& selected = {});

} // namespace dewpoint::setup
