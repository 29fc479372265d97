// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/camera_motion/agreement/camera_disagreement.h"
#include "core/capture/frame.h"
#include "core/geometry/camera.h"
#include "core/session/frames/color_histograms.h"
#include "core/session/frames/latency_stages.h"
#include "core/session/frames/tracked_frame.h"
#include "core/session/people/person_shape.h"
#include "core/session/snapshot/tracking_state.h"
#include "core/session/watch/camera_motion_watch.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/clock_estimate.h"

#include <Eigen/Core>

#include <chrono>
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
  Eigen::ArrayXXd particles; ///< positions of up to 10,000 particles: rows of x, y, z; meters
  Eigen::ArrayXd weights;    ///< weight of each row's particle, linear (not logarithmic)
  /// Positions in the last frames, which are drawn as a tail, in meters, oldest first; NaN where
  /// the target was not held (confirmed by the cameras).
  std::vector<Eigen::Vector3d> tailPositions;
  std::optional<Eigen::Vector3d> truth;
  TargetStatus status = TargetStatus::Searching;
  TrackingState stateWhileAbsent = TrackingState::Gone; ///< state shown while the target is absent
  BoxParticles boxParticles; ///< particles, if the target is tracked as a box in an image
  /// Color histograms of a target that is tracked as a box in an image (BoxEstimate); null if there
  /// is no image.
  std::shared_ptr<const ColorHistograms> histograms;
  /// Per camera: whether it confirms the target, and the reason if it does not
  /// (describeUnconfirmedCameras()); may be empty.
  std::vector<CameraReport> cameraReports;
  /// Candidate positions of the target in this frame; may be empty.
  std::vector<CandidatePosition> positionCandidates;
  /// Log likelihood around the target in each camera's image; empty unless requested.
  std::vector<LikelihoodMap> maps;
  std::shared_ptr<const PersonShape> shape; ///< shape of a person; null unless requested

  /// Return the estimate as a box or as a person; null if the estimate is of another kind or
  /// absent. Use these functions only where the kind of target is known; otherwise, visit the
  /// variant or call peopleIn().
  const BoxEstimate* box() const { return std::get_if<BoxEstimate>(&estimate); }
  const PersonEstimate* person() const { return std::get_if<PersonEstimate>(&estimate); }
};

/// State of playback, as shown to the user.
enum class PlayState { Paused, Playing, Ended };

/// Range of frames that can be shown, and the memory used for them.
struct HistoryState {
  std::int64_t firstFrame = 0;          ///< oldest frame that can be shown
  std::int64_t lastFrame = -1;          ///< newest frame that can be shown; -1: none yet
  std::int64_t newestTrackedFrame = -1; ///< newest frame that was tracked; -1: none yet
  std::size_t memoryBytes = 0; ///< memory used by images, particles and copies of the method
  std::size_t maxMemoryBytes = 0;
};

/// Range of past frames that a run is tracking again.
struct RerunState {
  std::int64_t firstFrame = 0; ///< first frame tracked again
  std::int64_t lastFrame = 0;  ///< last frame tracked again
};

/// Statistics of how well a run meets its time budget per iteration (parameter `time_budget`),
/// since the budget was set or the run began.
struct BudgetStatistics {
  double budgetMilliseconds = 0.0;     ///< time budget per iteration; 0: none
  std::int64_t iterationCount = 0;     ///< number of iterations
  std::int64_t lateIterationCount = 0; ///< number of iterations that took longer than the budget
};

/// Everything that views can show of one frame. Immutable once published.
struct TrackSnapshot {
  std::shared_ptr<const CameraRig> rig;
  MethodFamily family; ///< family of the method that produced these results
  FrameSetPtr frames;  ///< null before the first frame
  /// Per camera: the background image, which shows the scene without targets; empty if it is not
  /// known.
  std::vector<cv::Mat> backgroundImages;
  /// Per camera, CV_8UC1: pixels with the value 255 - k have the color of target k. Empty unless
  /// requested.
  std::vector<cv::Mat> masks;
  bool masksShowMotion = false; ///< true if `masks` mark moving pixels (255) instead of colors
  /// Likelihood of motion at each pixel, per camera, for methods that compute it; empty unless
  /// requested.
  std::vector<LikelihoodMap> motionMaps;
  std::vector<TargetSnapshot> targets;
  /// State of each camera, only for methods for people; empty for other methods.
  std::vector<PeopleCameraState> peopleCameras;
  std::int64_t frame = -1; ///< number of the frame shown
  bool isPast = false;     ///< true if the frame shown is not the current frame of the run
  bool isTracked = false;  ///< true if the frame shown was tracked
  /// True if the images are small previews, scaled up. The full images follow immediately, unless
  /// another frame is requested.
  bool isPreview = false;
  HistoryState history;            ///< other frames that can be shown
  std::optional<RerunState> rerun; ///< set while past frames are tracked again
  std::optional<std::int64_t> frameCount;
  std::int64_t iterationCount = 0;       ///< filter iterations since the (re)start
  double sourceFramesPerSecond = 0.0;    ///< frame rate of the recording or cameras; 0: unknown
  double framesPerSecond = 0.0;          ///< frame rate that the run achieves
  double microsecondsPerIteration = 0.0; ///< median duration of the last iterations, per target
  Latency latency;                       ///< time from the arrival of a frame set to its estimate
  LiveLatency liveLatency; ///< latency of live images, by stage; all zero for recordings
  BudgetStatistics budget;
  std::int64_t droppedFrameCount = 0;
  std::uint64_t seed = 0;
  PlayState state = PlayState::Paused;
  /// Instant at which the newest estimate of the run was finished; zero before the first estimate.
  std::chrono::steady_clock::time_point estimatedAt{};
  std::vector<Error> notices;
  /// Cameras that have moved since the run began. Each also has a notice, at the end of `notices`.
  std::vector<CameraMotionReport> cameraMotions;
  /// Reasons why the cameras contradict each other, the most basic first. These are not in
  /// `notices`.
  std::vector<CameraDisagreement> disagreements;
  /// Estimated clock errors of the cameras after the current frame; empty if the method estimates
  /// none.
  std::vector<ClockEstimate> clocks;
};
using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// Values of one filter iteration for one target, for plots over time or over iterations.
struct IterationRecord {
  /// Number of the iteration since the start or restart, counted from 1.
  std::int64_t iteration = 0;
  std::int64_t frame = 0;
  int target = 0;
  double spread = 0.0; ///< spread of the particles: root mean square over all axes, meters
  double effectiveSampleSize = 0.0;
  double distanceToTruth = -1.0;     ///< distance from the truth in meters; negative if unknown
  double frameTime = 0.0;            ///< time of the frame, seconds
  double durationMicroseconds = 0.0; ///< duration of this iteration, per target
  /// Standard deviations of x, y and z, meters.
  Eigen::Vector3d spreadPerAxis = Eigen::Vector3d::Zero();
  int particleCount = 0;
  /// Probability that the target exists, from all cameras together.
  double existenceProbability = 0.0;
  bool isConfirmed = false; ///< true if the cameras confirm the target
  /// Likelihood, existence probability and visible fraction of the target per camera, in the order
  /// of the rig; empty if the method does not compute them.
  std::vector<CameraEvidence> cameraEvidence = {};
  /// Similarity of the colors in the box to those of the target, only for methods that track boxes;
  /// `spread` is then in pixels.
  std::optional<double> similarity = std::nullopt;
  /// Estimated position of the target: mean x, y and z in the world frame, meters. For a target
  /// tracked as a box, the center of the box in its image in pixels, without z. NaN if unknown.
  Eigen::Vector3d position = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  /// True position of the target, meters; NaN if unknown.
  Eigen::Vector3d truth = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  double boxWidth = std::numeric_limits<double>::quiet_NaN();  ///< width of a box, pixels
  double boxHeight = std::numeric_limits<double>::quiet_NaN(); ///< height of a box, pixels
};

} // namespace dewpoint::session
