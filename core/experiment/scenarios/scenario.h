// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame.h"
#include "core/geometry/camera.h"
#include "core/tracking/tracker.h"
#include "core/trajectory/trajectory.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// How kind the images are: `Ideal` has sensor noise, shading and clutter, but perfect
/// calibration; `Room` adds calibration noise, lens distortion, JPEG and uneven light.
enum class Grade { Ideal, Room };

/// Something that happens at a frame and that metrics refer to.
struct ScenarioEvent {
  enum class Kind {
    Jump,
    BlackoutBegin,
    BlackoutEnd,
    Vanish,
    Return,
    CameraLost,
    CameraBack,
    Bump
  };
  Kind kind = Kind::Jump;
  std::int64_t frame = 0;
  int camera = -1; ///< which camera it happens to; -1: all, or none in particular
};

/// One seeded run of a scenario: what a method may know, and the truth it is measured against.
struct ScenarioRun {
  std::string scenario;
  Grade grade = Grade::Ideal;
  std::uint64_t seed = 0;
  CameraRig rig;     ///< as the method believes it
  CameraRig trueRig; ///< as the images were rendered, until a camera is moved
  std::vector<Target> targets;
  Eigen::Vector3d startCenter = Eigen::Vector3d::Zero(); ///< where the search starts, meters
  Eigen::Vector3d startHalf = Eigen::Vector3d::Zero();   ///< half size of the box around it
  double framesPerSecond = 30.0;
  std::int64_t frameCount = 0;
  /// One sample per target and frame; not `valid` while the target is not in the scene.
  Trajectory truth;
  std::vector<ScenarioEvent> events;
  /// The images of frame k: a pure function, so that methods see the same bits.
  std::function<FrameSetPtr(std::int64_t)> frames;
};

/// A scenario of the suite, declared once.
struct ScenarioDeclaration {
  std::string name;     ///< "S4-desk-cloud"
  std::string family;   ///< "S4"
  std::string sentence; ///< what happens in it
  int seeds = 20;       ///< runs of a report unless requested otherwise
  std::function<Result<ScenarioRun>(std::uint64_t seed, Grade grade)> make;
};

/// All scenarios, in the order of the report.
const std::vector<ScenarioDeclaration>& scenarioCatalog();

} // namespace dewpoint::experiment
