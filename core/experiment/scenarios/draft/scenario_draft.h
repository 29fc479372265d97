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

/// Frame times of a camera: frame j is taken at `offset` + j / `framesPerSecond` seconds.
struct CameraClock {
  double framesPerSecond = simulation::kUsualFrameRate;
  double offset = 0.0;
};

/// Run of a scenario while it is being built.
struct ScenarioDraft {
  std::string name;
  Grade grade = Grade::Ideal;
  std::uint64_t seed = 0;
  Draws draws;
  CameraRig rig; ///< true cameras
  simulation::Stage stage = {};
  std::vector<std::size_t> targets = {}; ///< indices of the tracked bodies of the stage
  bool radiusKnown = true;               ///< whether methods know the size of the targets
  Eigen::Vector3d startCenter = Eigen::Vector3d::Zero();
  Eigen::Vector3d startHalf = Eigen::Vector3d::Zero();
  double framesPerSecond = simulation::kUsualFrameRate;
  std::int64_t frameCount = 0;
  /// One per camera. If empty, all cameras take frame k with set k.
  std::vector<CameraClock> clocks = {};
  /// Whether a frame does not arrive.
  std::function<bool(std::size_t camera, std::int64_t frame)> lost = nullptr;
  std::vector<ScenarioEvent> events = {};
  /// Changes the faults that the grade has drawn, or those of an ideal run: the faults that the
  /// scenario is about. Called when everything else is complete.
  std::function<void(SensingFaults&)> adjustFaults = nullptr;
  /// One per camera, set by the grade and the scenario's faults. If empty, all times are known and
  /// all frames arrive.
  std::vector<CameraTiming> timings = {};

  /// Room in the stage's views, for views of additional cameras.
  std::shared_ptr<const simulation::Room> room = nullptr;
  /// Factor of the extent of smooth paths; below 1 if the cameras show less.
  double pathScale = 1.0;
  /// Factor of the radius of balls, applied when the scenario is complete; at most 1.
  double radiusScale = 1.0;
  int equalCandidates = 1; ///< see ScenarioRun
  /// Whether calibration and time stamps are exact in grade `ideal`, and methods know this.
  bool exactWhenIdeal = true;
  /// Sets what methods know about the targets, from the images of the finished run. If null, they
  /// know the color range of the pink ball.
  std::function<void(const ScenarioDraft&, ScenarioRun&)> teach = nullptr;

  /// Radius of a usual ball when the scenario is complete, meters.
  double ballRadius() const { return radiusScale * kBallRadius; }
  /// Time of a frame, seconds.
  double timeOf(std::int64_t frame) const { return static_cast<double>(frame) / framesPerSecond; }
};

/// Declaration of a scenario: its name and the function that completes its draft. The function
/// returns false if it finds no position at which all that must be visible is visible.
struct ScenarioRecipe {
  std::string name;
  std::string sentence;
  CameraRig rig;
  simulation::Furnishing furnishing = simulation::Furnishing::ClutteredDesk;
  std::function<bool(ScenarioDraft&)> complete = nullptr;
  /// Color of the target, BGR in full light. In grade `wild`, some of the clutter has it too.
  Eigen::Vector3d targetColor = simulation::kUsualBallColor;
};

/// Converts a recipe to a declaration. Runs share the cache's views of the room at rest.
ScenarioDeclaration declared(ScenarioRecipe recipe, std::shared_ptr<simulation::ViewCache> cache);

/// Adds a pink ball to be tracked ("ball 1", "ball 2", ...).
void addTarget(ScenarioDraft& draft, simulation::Path path, double radius = kBallRadius);

/// Starts the search near the first target's true first position: in a box of half size 0.1 m whose
/// center is off by up to 0.05 m along each axis.
void startNearTruth(ScenarioDraft& draft);

/// Starts the search in a box that contains the first positions of all targets, with a margin of
/// 0.05 m.
void startAroundAll(ScenarioDraft& draft);

} // namespace dewpoint::experiment::scenarios
