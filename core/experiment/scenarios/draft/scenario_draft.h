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

/// Ball radius in most scenarios, meters.
inline constexpr double kBallRadius = simulation::kDefaultBallRadius;

/// Frame times of a camera. Frame j is taken at `offsetSeconds` + j / `framesPerSecond` seconds.
struct CameraClock {
  double framesPerSecond = simulation::kDefaultFrameRate;
  double offsetSeconds = 0.0;
};

/// Draft of a run of a scenario, which the scenario's recipe completes step by step.
struct ScenarioDraft {
  std::string name;
  Grade grade = Grade::Ideal;
  std::uint64_t seed = 0;
  RandomDraws draws;
  CameraRig rig; ///< true calibration of the cameras
  simulation::Stage stage = {};
  std::vector<std::size_t> targets = {}; ///< indices of the tracked bodies in Stage::bodies
  bool isRadiusKnown = true;             ///< true if methods know the radius of the targets
  Eigen::Vector3d startCenter = Eigen::Vector3d::Zero();
  Eigen::Vector3d startHalfSize = Eigen::Vector3d::Zero();
  double framesPerSecond = simulation::kDefaultFrameRate;
  std::int64_t frameCount = 0;
  /// Clocks, one per camera. If empty, all cameras take their frame k at the time of frame set k.
  std::vector<CameraClock> clocks = {};
  /// Returns whether a frame is lost and does not arrive.
  std::function<bool(std::size_t camera, std::int64_t frame)> lost = nullptr;
  std::vector<ScenarioEvent> events = {};
  /// Changes the faults drawn for the grade (level of realism), or the faults of an ideal run. A
  /// scenario uses this function to set the faults that it tests. It is called when everything else
  /// in the draft is complete.
  std::function<void(SensingFaults&)> adjustFaults = nullptr;
  /// Timing faults, one per camera, set by the grade and by the scenario. If empty, all times are
  /// known and all frames arrive.
  std::vector<CameraTiming> timings = {};

  /// Room that surrounds the stage, from which views for additional cameras are made.
  std::shared_ptr<const simulation::Room> room = nullptr;
  /// Scale factor for the extent of smooth paths. It is below 1 if the cameras see a smaller volume
  /// than usual.
  double pathScale = 1.0;
  /// Scale factor for ball radii, at most 1. It is applied when the scenario is complete.
  double radiusScale = 1.0;
  /// Number of objects that fit the first target equally well (ScenarioRun::equalCandidateCount).
  int equalCandidateCount = 1;
  /// True if calibration and time stamps are exact in grade `ideal`, and methods know this.
  bool isCalibrationExactWhenIdeal = true;
  /// Function that sets what methods know about the targets (ScenarioRun::targets), using the
  /// images of the finished run. If null, methods know the color range of the pink ball.
  std::function<void(const ScenarioDraft&, ScenarioRun&)> learnTargets = nullptr;

  /// Returns the radius of a ball of default size in the complete scenario, meters.
  double ballRadius() const { return radiusScale * kBallRadius; }
  /// Returns the time of a frame, seconds.
  double timeOf(std::int64_t frame) const { return static_cast<double>(frame) / framesPerSecond; }
};

/// Recipe for a scenario: its name, its rig and room, and the function `complete`, which adds
/// targets and other objects to the draft of a run. `complete` returns false if it finds no
/// position at which everything that must be visible is visible.
struct ScenarioRecipe {
  std::string name;
  std::string description;
  CameraRig rig;
  simulation::Furnishing furnishing = simulation::Furnishing::ClutteredDesk;
  std::function<bool(ScenarioDraft&)> complete = nullptr;
  /// Target color, BGR in full light. In the grade (level of realism) `wild`, some of the clutter
  /// has the same color.
  Eigen::Vector3d targetColor = simulation::kDefaultBallColor;
};

/// Converts a recipe to a scenario declaration. All runs of the scenario share `cache`, which holds
/// the rendered views of the room at rest.
ScenarioDeclaration declareScenario(ScenarioRecipe recipe,
                                    std::shared_ptr<simulation::ViewCache> cache);

/// Adds a pink ball as a target. The balls are named "ball 1", "ball 2", and so on.
void addTarget(ScenarioDraft& draft, simulation::Path path, double radius = kBallRadius);

/// Sets the start volume to a box near the true initial position of the first target. The box has a
/// half size of 0.1 m, and its center is off by up to 0.05 m along each axis.
void startNearTruth(ScenarioDraft& draft);

/// Sets the start volume to a box that contains the initial positions of all targets, with a margin
/// of 0.05 m.
void startAroundAllTargets(ScenarioDraft& draft);

} // namespace dewpoint::experiment::scenarios
