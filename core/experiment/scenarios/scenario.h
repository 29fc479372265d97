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

/// Event in a run at a certain frame. Metrics use events, for example to measure how fast a target
/// is found again after a jump.
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
    /// From this frame on, the target is hidden or outside the image of the camera (camera -1: of
    /// all cameras).
    UnseenBegin,
    UnseenEnd, ///< from this frame on, the target is at least partly visible again
  };
  Kind kind = Kind::Jump;
  std::int64_t frame = 0;
  int camera = -1; ///< index of the affected camera; -1: all cameras, or no particular camera
};

/// True center of a target in one image of a real clip, called a mark.
struct MarkedCenter {
  std::int64_t frame = 0; ///< frame number in the run
  std::size_t target = 0; ///< index among the run's targets
  std::size_t camera = 0; ///< index of the camera in the rig
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// Size of a target of any shape. Meters.
struct TargetExtent {
  double radius = 0.0; ///< radius of a ball with the same volume as the target
  /// Semi-axes, longest first, of the solid ellipsoid whose points have the same covariance as the
  /// target's points. They are sqrt(5) times the standard deviations along the principal axes. For
  /// a ball, they equal its radius.
  Eigen::Vector3d halfAxes = Eigen::Vector3d::Zero();
};

/// Run of a scenario with one seed: what a method may know, and the truth for its evaluation.
struct ScenarioRun {
  std::string scenario;
  Grade grade = Grade::Ideal;
  std::uint64_t seed = 0;
  CameraRig rig; ///< calibration that the method receives
  /// True if methods know that calibration and time stamps are exact. Otherwise methods use their
  /// default assumptions about the errors.
  bool isSensingExact = false;
  /// True calibration of the cameras that rendered the images, valid until a camera is moved.
  CameraRig trueRig;
  std::vector<Target> targets;
  /// Center of the volume in which the search starts, meters.
  Eigen::Vector3d startCenter = Eigen::Vector3d::Zero();
  /// Half size of the volume in which the search starts, meters.
  Eigen::Vector3d startHalfSize = Eigen::Vector3d::Zero();
  double framesPerSecond = simulation::kDefaultFrameRate;
  std::int64_t frameCount = 0;
  /// True trajectory, with one sample per target and frame. A sample is not `isValid` while the
  /// target is not in the scene. The position is the center of a ball, or the centroid of any other
  /// target.
  Trajectory truth;
  std::vector<TargetExtent> extents; ///< target sizes, one per sample of `truth`, in the same order
  /// Standard deviation of the errors of `truth` along each axis, meters. Comparisons with
  /// estimates take this uncertainty into account.
  double truthSigma = 0.0;
  std::vector<ScenarioEvent> events;
  /// Delay of the time stamps of each camera at the end of the run, without jitter, in seconds.
  /// Methods do not know this delay. Empty for real recordings.
  std::vector<double> finalTimeStampDelays = {};
  /// Frames with a known truth, ascending. Only these frames are evaluated. If empty, all frames
  /// are evaluated.
  std::vector<std::int64_t> measuredFrames;
  /// True target centers in the images of a real clip. A run with marks but without `truth` is
  /// evaluated in pixels only.
  std::vector<MarkedCenter> markedCenters;
  /// Limit in pixels for the distance between a mark and the projection of an estimate. In a frame
  /// with marks, an estimate counts as being on its target if all these distances are below the
  /// limit.
  double markGatePx = 0.0;
  /// Number of objects in the images that fit the first target equally well in start position,
  /// color and size. If there are several, no image ever shows which object is the target, so a
  /// correct method reports a probability of at most 1 / equalCandidateCount for an estimate.
  int equalCandidateCount = 1;
  /// Returns the images of frame k. This is a pure function, so all methods see identical images.
  std::function<FrameSetPtr(std::int64_t)> frames;
};

/// Declaration of a scenario of the accuracy suite.
struct ScenarioDeclaration {
  std::string name;        ///< name, for example "S4-desk-cloud"
  std::string family;      ///< group of similar scenarios, for example "S4"
  std::string description; ///< what happens in the scenario
  int seedCount = 20;      ///< default number of runs in a report
  /// Creates the run for a seed and grade. Returns Undetermined if the random draws allow no run,
  /// for example if they find no position at which everything that must be visible is visible. The
  /// suite then skips this run. Any other error stops the suite.
  std::function<Result<ScenarioRun>(std::uint64_t seed, Grade grade)> make;
  /// True for real clips, which exist in grade `Real` only; false for rendered scenarios, which
  /// exist in all other grades.
  bool isRecorded = false;
  /// Loads the images and true boxes of a scenario recorded by one camera, for methods that follow
  /// boxes. Used instead of `make`.
  std::function<Result<BoxClip>()> clip = nullptr;
};

} // namespace dewpoint::experiment
