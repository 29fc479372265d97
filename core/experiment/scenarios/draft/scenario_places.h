// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/draft/scenario_draft.h"

namespace dewpoint::experiment::scenarios {

/// How often a position is drawn again before a scenario gives up; chosen: a second or so.
inline constexpr int kMostDraws = 4000;
/// How often a whole layout is drawn again before a scenario gives up; chosen, as each costs many
/// positions.
inline constexpr int kMostLayouts = 50;

/// Frames of a run: 6 s at simulation::kUsualFrameRate, once round the smooth path; chosen.
inline constexpr std::int64_t kUsualFrames = 180;

/// Where the middle of a ball's path on the desk is drawn, world, meters: chosen so that both
/// cameras of the demo rig see all of most paths.
inline const Eigen::Vector3d kPathLow{0.46, 0.46, 0.12};
inline const Eigen::Vector3d kPathHigh{0.56, 0.58, 0.18};

/// Seconds once round the smooth path, and the fast one: 0.1 to 0.3 m/s, and five times that.
inline constexpr double kSlowRound = 6.0;
inline constexpr double kFastRound = 1.2;

/// A closed path: center + extent .* (sin a, sin 2a, sin 3a), each with a phase of its own, once
/// round in `period` seconds.
struct RoundPath {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< meters
  Eigen::Vector3d extent = Eigen::Vector3d::Zero(); ///< meters
  Eigen::Vector3d phase = Eigen::Vector3d::Zero();  ///< radians
  double period = kSlowRound;                       ///< seconds
  Eigen::Vector3d operator()(double time) const;
};

/// True if the sphere's whole outline lies in the camera's image and nothing at rest hides it.
bool fullyVisible(const simulation::RoomView& view, const Eigen::Vector3d& center, double radius);
/// True if the sphere's whole outline lies in the camera's image, hidden or not.
bool withinImage(const simulation::RoomView& view, const Eigen::Vector3d& center, double radius);
/// As fullyVisible(), in every camera.
bool fullyVisible(const simulation::Stage& stage, const Eigen::Vector3d& center, double radius);
/// The same at every frame of the draft.
bool staysVisible(const ScenarioDraft& draft, const simulation::Path& path, double radius);

/// True if the outlines of two spheres are apart in the camera's image, by `gap` radians.
bool apart(const simulation::RoomView& view, const Eigen::Vector3d& one, double oneRadius,
           const Eigen::Vector3d& other, double otherRadius, double gap = 0.0);

/// A path on the desk that stays in all images; `fast`: a round in kFastRound.
std::optional<RoundPath> drawDeskPath(ScenarioDraft& draft, bool fast, double radius = kBallRadius);

/// One ball to be tracked on a desk path for `frames` frames, and a search that starts near it;
/// false when no path was found.
bool addDeskBall(ScenarioDraft& draft, std::int64_t frames, bool fast = false);

} // namespace dewpoint::experiment::scenarios
