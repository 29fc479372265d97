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
    Bump,
    UnseenBegin, ///< from this frame on the camera sees nothing of the target: it is outside the
                 ///< image or hidden (camera -1: so in all cameras)
    UnseenEnd,   ///< from this frame on it sees some of it again
  };
  Kind kind = Kind::Jump;
  std::int64_t frame = 0;
  int camera = -1; ///< which camera it happens to; -1: all, or none in particular
};

/// The center of a target in one image of a real clip, as the clip's truth states it.
struct MarkedCenter {
  std::int64_t frame = 0; ///< of the run
  std::size_t target = 0; ///< in the order of the run's targets
  std::size_t camera = 0; ///< in the order of the rig
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// How large a target is, whatever its shape. Meters.
struct TargetExtent {
  double radius = 0.0; ///< of a ball of its volume
  /// Semi-axes of the solid ellipsoid with its second moments, the longest first: sqrt(5) times the
  /// standard deviations of its points along their principal axes. Of a ball: its radius.
  Eigen::Vector3d halfAxes = Eigen::Vector3d::Zero();
};

/// One seeded run of a scenario: what a method may know, and the truth it is measured against.
struct ScenarioRun {
  std::string scenario;
  Grade grade = Grade::Ideal;
  std::uint64_t seed = 0;
  CameraRig rig; ///< as the method believes it
  /// Whether a method is told that the calibration and the time stamps are exact. If not, it goes
  /// by what it assumes of any rig.
  bool exactSensing = false;
  CameraRig trueRig; ///< as the images were rendered, until a camera is moved
  std::vector<Target> targets;
  Eigen::Vector3d startCenter = Eigen::Vector3d::Zero(); ///< where the search starts, meters
  Eigen::Vector3d startHalf = Eigen::Vector3d::Zero();   ///< half size of the box around it
  double framesPerSecond = simulation::kUsualFrameRate;
  std::int64_t frameCount = 0;
  /// One sample per target and frame; not `valid` while the target is not in the scene. The
  /// position is the center of a ball, and the centroid of any other target.
  Trajectory truth;
  std::vector<TargetExtent> extents; ///< one per sample of `truth`, in its order
  /// How exact `truth` is: standard deviation along each axis, meters. Beliefs are compared with a
  /// truth that is this uncertain.
  double truthSigma = 0.0;
  std::vector<ScenarioEvent> events;
  /// Frames with a truth, ascending: only these are measured. Empty: all frames are.
  std::vector<std::int64_t> measuredFrames;
  /// Of real clips. A run with marks and without `truth` is measured in pixels only.
  std::vector<MarkedCenter> marks;
  /// An estimate is on its target when its projections are no farther from the marks, pixels.
  double markGate = 0.0;
  /// How many objects in the images are the first target as well as each other, as far as start,
  /// color and size can tell. 1: the start says which one is meant. More: nothing does, at any
  /// time, and an honest P that an estimate is the target is at most 1 / equalCandidates.
  int equalCandidates = 1;
  /// The images of frame k: a pure function, so that methods see the same bits.
  std::function<FrameSetPtr(std::int64_t)> frames;
};

/// A scenario of the suite, declared once.
struct ScenarioDeclaration {
  std::string name;     ///< "S4-desk-cloud"
  std::string family;   ///< "S4"
  std::string sentence; ///< what happens in it
  int seeds = 20;       ///< runs of a report unless requested otherwise
  /// Undetermined when chance has drawn no run for this seed and grade, such as no position at
  /// which everything is seen that must be: the suite then skips this run. Any other error stops
  /// it.
  std::function<Result<ScenarioRun>(std::uint64_t seed, Grade grade)> make;
  bool recorded = false; ///< a real clip: of grade `Real` only; all others are of every other grade
  /// Of a recorded scenario, instead of `make`: the images of one camera with the true boxes, for
  /// methods that follow boxes.
  std::function<Result<BoxClip>()> clip = nullptr;
};

} // namespace dewpoint::experiment
