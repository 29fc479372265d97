// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/draft/scenario_draft.h"

namespace dewpoint::experiment::scenarios {

/// Maximum number of attempts to draw a position before a scenario gives up. This many attempts
/// take about a second.
inline constexpr int kMaxDrawAttempts = 4000;
/// Maximum number of attempts to draw a whole layout before a scenario gives up. It is small
/// because each layout requires many positions.
inline constexpr int kMaxLayoutAttempts = 50;

/// Number of frames in a run: 6 s at simulation::kDefaultFrameRate, which is one round of the
/// smooth path.
inline constexpr std::int64_t kDefaultFrameCount = 180;

/// Bounds for the center of a ball's path on the desk (world, meters), chosen so that both cameras
/// of the demo rig see most paths completely.
inline const Eigen::Vector3d kPathLow{0.46, 0.46, 0.12};
inline const Eigen::Vector3d kPathHigh{0.56, 0.58, 0.18};

/// Duration of one round of a slow closed path, seconds. On such a path, a ball moves at 0.1 to 0.3
/// m/s.
inline constexpr double kSlowPathPeriod = 6.0;
/// Duration of one round of a fast closed path, seconds. On such a path, a ball moves five times as
/// fast as on a slow one.
inline constexpr double kFastPathPeriod = 1.2;

/// Closed path. Each coordinate k (1: x, 2: y, 3: z) is center[k] + extent[k] * sin(k a +
/// phase[k]), where the angle a = 2 pi time / periodSeconds. One round takes `periodSeconds`
/// seconds.
struct LissajousPath {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< center of the path, meters
  /// Half of the path's extent along each axis, meters.
  Eigen::Vector3d extent = Eigen::Vector3d::Zero();
  Eigen::Vector3d phase = Eigen::Vector3d::Zero(); ///< phase of each coordinate at time 0, radians
  double periodSeconds = kSlowPathPeriod;          ///< duration of one round, seconds
  Eigen::Vector3d operator()(double time) const;
};

/// Returns whether the sphere's whole outline is inside the camera's image and no object at rest
/// hides it. World frame, meters.
bool isFullyVisible(const simulation::RoomView& view, const Eigen::Vector3d& center, double radius);
/// Returns whether the sphere's whole outline is inside the camera's image, even if the sphere is
/// hidden.
bool isWithinImage(const simulation::RoomView& view, const Eigen::Vector3d& center, double radius);
/// Returns whether the sphere is fully visible in every camera.
bool isFullyVisible(const simulation::Stage& stage, const Eigen::Vector3d& center, double radius);
/// Returns whether the sphere is fully visible in every frame of the draft.
bool staysVisible(const ScenarioDraft& draft, const simulation::Path& path, double radius);

/// Returns whether the outlines of two spheres are separated by an angle of more than `gap`
/// radians, as seen from the camera.
bool areSeparated(const simulation::RoomView& view, const Eigen::Vector3d& one, double oneRadius,
                  const Eigen::Vector3d& other, double otherRadius, double gap = 0.0);

/// Draws a random closed path above the desk that stays inside all images. A round takes
/// kSlowPathPeriod, or kFastPathPeriod if `fast` is true. Returns nothing if no such path was
/// found.
std::optional<LissajousPath> randomDeskPath(ScenarioDraft& draft, bool fast,
                                            double radius = kBallRadius);

/// Adds one target ball that moves on a path from randomDeskPath() for `frames` frames, and sets
/// the volume in which methods start to search to a box near the true initial position
/// (startNearTruth()). Returns false if no path was found.
bool addDeskBall(ScenarioDraft& draft, std::int64_t frames, bool fast = false);

} // namespace dewpoint::experiment::scenarios
