// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/draft/scenario_draft.h"

namespace dewpoint::experiment::scenarios {

/// How often a position is drawn again before a scenario gives up.
inline constexpr int kMostDraws = 4000;
/// How often a whole layout is drawn again before a scenario gives up. Origin not recorded.
inline constexpr int kMostLayouts = 50;

/// Frames of a run of 6 s, at 30 per second.
inline constexpr std::int64_t kUsualFrames = 180;

/// A closed path: center + extent .* (sin a, sin 2a, sin 3a), each with a phase of its own, once
/// round in `period` seconds.
struct RoundPath {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< meters
  Eigen::Vector3d extent = Eigen::Vector3d::Zero(); ///< meters
  Eigen::Vector3d phase = Eigen::Vector3d::Zero();  ///< radians
  double period = 6.0;                              ///< seconds
  Eigen::Vector3d operator()(double time) const;
};

/// True if the sphere's whole outline lies in the camera's image and nothing at rest hides it.
bool fullyVisible(const simulation::CameraView& view, const Eigen::Vector3d& center, double radius);
/// The same in every camera.
bool fullyVisible(const simulation::Stage& stage, const Eigen::Vector3d& center, double radius);
/// The same at every frame of the draft.
bool staysVisible(const ScenarioDraft& draft, const simulation::Path& path, double radius);

/// True if the outlines of two spheres are apart in the camera's image, by `gap` radians.
bool apart(const simulation::CameraView& view, const Eigen::Vector3d& one, double oneRadius,
           const Eigen::Vector3d& other, double otherRadius, double gap = 0.0);

/// A path on the desk that stays in all images; `fast`: a round in 1.2 s instead of 6.
std::optional<RoundPath> drawDeskPath(ScenarioDraft& draft, bool fast, double radius = kBallRadius);

/// One ball to be tracked on a desk path for `frames` frames, and a search that starts near it;
/// false when no path was found.
bool addDeskBall(ScenarioDraft& draft, std::int64_t frames, bool fast = false);

} // namespace dewpoint::experiment::scenarios
