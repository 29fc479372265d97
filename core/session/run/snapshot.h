// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/capture/frame.h"
#include "core/geometry/camera.h"
#include "core/session/frames/color_histograms.h"
#include "core/session/frames/tracked_frame.h"
#include "core/session/people/person_shape.h"
#include "core/session/run/camera_motion_watch.h"
#include "core/session/run/hold_state.h"
#include "core/tracking/catalog/method_catalog.h"

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::session {

/// One target of a snapshot.
struct TargetSnapshot {
  Target target;
  TrackEstimate estimate;
  Eigen::ArrayXXd particles; ///< up to 10,000 rows x y z, meters
  Eigen::ArrayXd weights;    ///< one per row, linear
  std::vector<Eigen::Vector3d>
      tail; ///< positions in the last frames, oldest first; NaN where not held
  std::optional<Eigen::Vector3d> truth;
  TargetStatus status = TargetStatus::Searching;
  HoldState absence = HoldState::Gone; ///< its state while it is absent
  BoxParticles boxParticles;           ///< of a BoxEstimate
  /// Of a BoxEstimate; null where it has no image.
  std::shared_ptr<const ColorHistograms> histograms;
  /// Per camera, why it does not confirm the target (reasonSentence); may be empty.
  std::vector<CameraReport> reasons;
  std::vector<CandidatePosition> proposals; ///< positions considered in this frame; may be empty
  std::vector<LikelihoodMap> maps;          ///< per camera; empty unless wanted
  std::shared_ptr<const PersonShape> shape; ///< of a person; null unless wanted

  /// What is believed of it as a box or as a person; null when it is something else, or absent. For
  /// whoever knows which it is: what depends on that visits the estimate, or takes peopleIn().
  const BoxEstimate* box() const { return std::get_if<BoxEstimate>(&estimate); }
  const PersonEstimate* person() const { return std::get_if<PersonEstimate>(&estimate); }
};

enum class PlayState { Paused, Playing, Ended };

/// Seconds from the arrival of a frame set to its estimate, over the run so far; 0 before that.
struct Latency {
  double median = 0.0;
  double p99 = 0.0;
  double longest = 0.0;
};

/// Which frames of the run can be shown, and what keeping them takes.
struct HistoryState {
  std::int64_t first = 0; ///< oldest frame that can be shown
  std::int64_t last = -1; ///< newest frame that can be shown; -1: none yet
  std::int64_t head = -1; ///< newest frame that was tracked; -1: none yet
  std::size_t bytes = 0;  ///< taken by images, particles and copies of the method
  std::size_t mostBytes = 0;
};

/// A run that goes over past frames again.
struct RerunState {
  std::int64_t from = 0; ///< the first frame tracked again
  std::int64_t to = 0;   ///< the last one
};

/// How well a run keeps to its time budget per iteration (parameter `time_budget`), since it was
/// set or the run began.
struct BudgetFigures {
  double milliseconds = 0.0;   ///< 0: there is none
  std::int64_t iterations = 0; ///< so far
  std::int64_t late = 0;       ///< of them, those that took longer
};

/// Everything a view may show of one frame. Immutable once published.
struct TrackSnapshot {
  std::shared_ptr<const CameraRig> rig;
  MethodFamily family;             ///< of the method whose results these are
  FrameSetPtr frames;              ///< null before the first frame
  std::vector<cv::Mat> emptyRooms; ///< per camera without targets; empty when that is not known
  /// Per camera CV_8UC1, 255 - k: color of target k. Empty unless wanted.
  std::vector<cv::Mat> masks;
  bool masksShowMotion = false; ///< instead; 255: it moves
  /// Per camera how likely motion is at each pixel of its image, of methods that map it; empty
  /// unless wanted.
  std::vector<LikelihoodMap> motionMaps;
  std::vector<TargetSnapshot> targets;
  std::vector<PeopleCameraState> peopleCameras; ///< per camera; empty but for methods for people
  std::int64_t frame = -1;                      ///< the one shown
  bool past = false;                            ///< another frame is shown than the run stands at
  bool tracked = false;                         ///< the frame shown was tracked
  /// The images are small previews, scaled up; the true ones follow at once unless another frame is
  /// requested.
  bool preview = false;
  HistoryState history;            ///< what else could be shown
  std::optional<RerunState> rerun; ///< while past frames are tracked again
  std::optional<std::int64_t> frameCount;
  std::int64_t iterations = 0;           ///< filter iterations since the (re)start
  double framesPerSecond = 0.0;          ///< achieved
  double microsecondsPerIteration = 0.0; ///< running median
  Latency latency;
  BudgetFigures budget;
  std::int64_t droppedFrames = 0;
  std::uint64_t seed = 0;
  PlayState state = PlayState::Paused;
  std::vector<Error> notices;
  /// Cameras that were moved since the run began; each has its notice too: the last ones there.
  std::vector<CameraMotionReport> cameraMotions;
  /// Why cameras cannot agree on where things are, the most basic reason first. They are not among
  /// the notices.
  std::vector<CameraDisagreement> disagreements;
};
using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// One filter iteration in the log that plots draw from; per target. Over time: `time`; over
/// iterations: `iteration`.
struct IterationRecord {
  std::int64_t iteration = 0; ///< since the (re)start, from 1
  std::int64_t frame = 0;
  int target = 0;
  double spread = 0.0; ///< meters, all axes together
  double effectiveSampleSize = 0.0;
  double error = -1.0;       ///< meters against truth; negative when unknown
  double time = 0.0;         ///< seconds, of the frame
  double microseconds = 0.0; ///< this iteration took, per target
  Eigen::Vector3d spreadPerAxis = Eigen::Vector3d::Zero(); ///< standard deviations x y z, meters
  int particleCount = 0;
  double existenceProbability = 0.0; ///< probability, all cameras together
  bool held = false;                 ///< see isHeld()
  /// Likelihood, existence and visible share per camera, in the order of the rig; empty when the
  /// method cannot tell.
  std::vector<CameraEvidence> cameras = {};
  /// Of a box (BoxEstimate::similarity); then the spread is in pixels.
  std::optional<double> similarity = std::nullopt;
  /// Mean x y z in the world, meters; of a box the center in its image, pixels, and nothing along
  /// z. Not a number where it is not known.
  Eigen::Vector3d position = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  /// Where the target truly is, meters; not a number where that is not known.
  Eigen::Vector3d truth = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  double boxWidth = std::numeric_limits<double>::quiet_NaN();  ///< of a box, pixels
  double boxHeight = std::numeric_limits<double>::quiet_NaN(); ///< of a box, pixels
};

} // namespace dewpoint::session
