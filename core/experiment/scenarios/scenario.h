// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame.h"
#include "core/experiment/boxes/box_clips.h"
#include "core/experiment/scenarios/grade.h"
#include "core/geometry/camera.h"
#include "core/simulation/sensor/usual_camera.h"
#include "core/tracking/tracker.h"
#include "core/trajectory/trajectory.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Event at a frame to which metrics refer.
struct ScenarioEvent {
  enum class Kind {
    Jump,
    BlackoutBegin,
    BlackoutEnd,
    Vanish,
    Return,
    CameraLost,
    CameraBack,
    CameraMoved,
    UnseenBegin, ///< from this frame on the camera sees nothing of the target: it is outside the
                 ///< image or hidden (camera -1: so in all cameras)
    UnseenEnd,   ///< from this frame on it sees some of it again
  };
  Kind kind = Kind::Jump;
  std::int64_t frame = 0;
  int camera = -1; ///< affected camera; -1: all, or no particular one
};

/// Center of a target in one image of a real clip, according to the clip's truth.
struct MarkedCenter {
  std::int64_t frame = 0; ///< number of the frame in the run
  std::size_t target = 0; ///< in the order of the run's targets
  std::size_t camera = 0; ///< in the order of the rig
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// Size of a target of any shape. Meters.
struct TargetExtent {
  double radius = 0.0; ///< radius of a ball of the same volume
  /// Semi-axes, the longest first, of the solid ellipsoid whose points have the same covariance:
  /// sqrt(5) times the standard deviations of the target's points along their principal axes. For a
  /// ball: its radius.
  Eigen::Vector3d halfAxes = Eigen::Vector3d::Zero();
};

/// One seeded run of a scenario: what a method may know, and the truth for its evaluation.
struct ScenarioRun {
  std::string scenario;
  Grade grade = Grade::Ideal;
  std::uint64_t seed = 0;
  CameraRig rig; ///< calibration that the method receives
  /// Whether a method knows that calibration and time stamps are exact. Otherwise it uses its
  /// assumptions for any rig.
  bool exactSensing = false;
  CameraRig trueRig; ///< cameras of the rendered images, until a camera is moved
  std::vector<Target> targets;
  /// Center of the volume in which the search starts, meters.
  Eigen::Vector3d startCenter = Eigen::Vector3d::Zero();
  Eigen::Vector3d startHalf = Eigen::Vector3d::Zero(); ///< half size of that volume, meters
  double framesPerSecond = simulation::kUsualFrameRate;
  std::int64_t frameCount = 0;
  /// One sample per target and frame; not `valid` while the target is not in the scene. The
  /// position is the center of a ball, or the centroid of any other target.
  Trajectory truth;
  std::vector<TargetExtent> extents; ///< one per sample of `truth`, in the same order
  /// Standard deviation of `truth` along each axis, meters. Beliefs are compared with a truth of
  /// this uncertainty.
  double truthSigma = 0.0;
  std::vector<ScenarioEvent> events;
  /// Frames with a truth, ascending; only these are evaluated. If empty, all frames are.
  std::vector<std::int64_t> measuredFrames;
  /// Marks of real clips. A run with marks but without `truth` is evaluated in pixels only.
  std::vector<MarkedCenter> marks;
  /// Largest distance of an estimate's projections from the marks, pixels, at which it counts as on
  /// its target.
  double markGate = 0.0;
  /// Number of objects in the images that fit the first target equally well, as far as start, color
  /// and size can tell. 1: the start determines which one is meant. More: nothing does at any time,
  /// and an honest P that an estimate is the target is at most 1 / equalCandidates.
  int equalCandidates = 1;
  /// Returns the images of frame k. A pure function, so that all methods see identical images.
  std::function<FrameSetPtr(std::int64_t)> frames;
};

/// Declaration of a scenario of the suite.
struct ScenarioDeclaration {
  std::string name;     ///< "S4-desk-cloud"
  std::string family;   ///< "S4"
  std::string sentence; ///< what happens in it
  int seeds = 20;       ///< runs of a report unless requested otherwise
  /// Makes the run of a seed and grade. Undetermined if the random draws allow no run, for example
  /// if they find no position at which all that must be visible is visible. The suite then skips
  /// this run. Any other error stops the suite.
  std::function<Result<ScenarioRun>(std::uint64_t seed, Grade grade)> make;
  bool recorded = false; ///< a real clip, with grade `Real` only; the others have all other grades
  /// Of a recorded scenario of one camera, instead of `make`: the images with the true boxes, for
  /// methods that follow boxes.
  std::function<Result<BoxClip>()> clip = nullptr;
};

} // namespace dewpoint::experiment
