// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/experiment/scenarios/draft/sensing_faults.h"
#include "core/experiment/scenarios/random_draws.h"
#include "core/experiment/scenarios/scenario.h"
#include "core/simulation/room/view_cache.h"
#include "core/simulation/scene/stage.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::experiment::scenarios {

/// Radius of the ball of most scenarios, meters.
inline constexpr double kBallRadius = simulation::kUsualBallRadius;

/// When a camera takes its frames: frame j at `offset` + j / `framesPerSecond` seconds.
struct CameraClock {
  double framesPerSecond = simulation::kUsualFrameRate;
  double offset = 0.0;
};

/// A scenario run in the making.
struct ScenarioDraft {
  std::string name;
  Grade grade = Grade::Ideal;
  std::uint64_t seed = 0;
  Draws draws;
  CameraRig rig; ///< the true cameras
  simulation::Stage stage = {};
  std::vector<std::size_t> targets = {}; ///< which bodies of the stage are to be tracked
  bool radiusKnown = true;               ///< whether methods know how large the targets are
  Eigen::Vector3d startCenter = Eigen::Vector3d::Zero();
  Eigen::Vector3d startHalf = Eigen::Vector3d::Zero();
  double framesPerSecond = simulation::kUsualFrameRate;
  std::int64_t frameCount = 0;
  /// One per camera; empty: all cameras take frame k with set k.
  std::vector<CameraClock> clocks = {};
  /// Frame does not arrive.
  std::function<bool(std::size_t camera, std::int64_t frame)> lost = nullptr;
  std::vector<ScenarioEvent> events = {};
  /// Changes what the grade has drawn, or what an ideal run has: the faults that the scenario is
  /// about. Called when all else is complete.
  std::function<void(SensingFaults&)> adjustFaults = nullptr;
  /// One per camera, set by the grade and the scenario's faults; empty: all is known and comes.
  std::vector<CameraTiming> timings = {};

  /// The room that the stage's views show, for views of further cameras.
  std::shared_ptr<const simulation::Room> room = nullptr;
  /// Of the extent of smooth paths; below 1 where the cameras show less.
  double pathScale = 1.0;
  /// Of the radius of balls, applied when the scenario is complete; at most 1.
  double radiusScale = 1.0;
  int equalCandidates = 1; ///< see ScenarioRun
  /// Whether calibration and time stamps are exact in grade `ideal`, and methods are told so.
  bool exactWhenIdeal = true;
  /// Sets what methods know about the targets from the images of the finished run; none: they know
  /// the range of the pink ball.
  std::function<void(const ScenarioDraft&, ScenarioRun&)> teach = nullptr;

  /// Of a usual ball when the scenario is complete, meters.
  double ballRadius() const { return radiusScale * kBallRadius; }
  double timeOf(std::int64_t frame) const { return static_cast<double>(frame) / framesPerSecond; }
};

/// What a scenario is declared with: its name and how its draft is completed. Nothing when no place
/// was found for what must be seen.
struct ScenarioRecipe {
  std::string name;
  std::string sentence;
  CameraRig rig;
  simulation::Furnishing furnishing = simulation::Furnishing::ClutteredDesk;
  std::function<bool(ScenarioDraft&)> complete = nullptr;
  /// Of the target, BGR in full light: some of what stands around in grade `wild` has it, too.
  Eigen::Vector3d targetColor = simulation::kUsualBallColor;
};

/// The declaration of a recipe. Runs share the cache's views of the room at rest.
ScenarioDeclaration declared(ScenarioRecipe recipe, std::shared_ptr<simulation::ViewCache> cache);

/// Adds a pink ball that is to be tracked ("ball 1", "ball 2", ...).
void addTarget(ScenarioDraft& draft, simulation::Path path, double radius = kBallRadius);

/// Lets the search start near the first target's true first position: a box of half size 0.1 m
/// whose center is up to 0.05 m off along each axis.
void startNearTruth(ScenarioDraft& draft);

/// Lets the search start in a box that holds the first positions of all targets with 0.05 m around
/// each.
void startAroundAll(ScenarioDraft& draft);

} // namespace dewpoint::experiment::scenarios
