// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"
#include "core/calibration/bundle/fault.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Default for the expected error of the orientations in an initial rig, radians. Chosen for
/// cameras that were placed by hand.
inline constexpr double kInitialRotationError = 0.06;
/// Default for the expected error of the positions in an initial rig, meters. Chosen for cameras
/// that were placed by hand.
inline constexpr double kInitialPositionError = 0.12;

/// Observation of a ball in one image.
struct MarkerObservation {
  double time = 0.0;    ///< seconds, by the camera's own clock
  std::size_t ball = 0; ///< index of the ball: 0, or 1 for the ball at the other end of a stick
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero(); ///< center of the ball's outline
  double radius = 0.0; ///< radius of the outline, pixels; 0: not measured
  double sigma = 0.3;  ///< standard deviation of `pixel` per axis, pixels
};

/// Method to determine the scale of the result.
enum class WandScale {
  InitialRig, ///< by the initial rig; the scale is only as accurate as this rig
  Stick,      ///< by the known length of the stick
  /// By the known distance between two positions that ball 0 touched (WandProblem::distance).
  Distance,
  Diameter ///< by the apparent radius of the ball, measured to about 0.05 px
};

/// Two times at which ball 0 was held at two positions with a known distance between them.
struct TouchedDistance {
  double firstTime = 0.0;  ///< time when ball 0 was at the first position, seconds
  double secondTime = 0.0; ///< time when ball 0 was at the second position, seconds
  double meters = 0.0;
};

/// Input of calibrateFromWand(): a wand, its views, and what to estimate.
struct WandProblem {
  CameraRig initialRig;                              ///< approximate poses of the cameras
  std::vector<std::vector<MarkerObservation>> views; ///< observations of the balls by each camera
  /// Radii of the balls, meters; 0: unknown, so that balls are treated as points.
  std::array<double, 2> ballRadii = {0.0, 0.0};
  /// Distance between the centers of balls 0 and 1, meters; 0: only one ball.
  double stickLength = 0.0;
  WandScale scaleMethod = WandScale::InitialRig;
  /// Known distance between two positions that ball 0 touched; used for WandScale::Distance.
  TouchedDistance distance;
  std::vector<double> floorTimes; ///< times when ball 0 lay on the floor or touched it, seconds
  std::optional<std::array<double, 2>>
      freeFallSpan;                  ///< time span in which ball 0 fell freely, seconds
  bool estimatesTimeOffsets = false; ///< estimate time offsets of the cameras relative to the first
  bool estimatesFocalLengths = false; ///< estimate focal lengths, keeping their ratio
  bool estimatesDistortion = false;   ///< estimate k1 for every camera
  /// Expected error of the initial rig's orientations, radians.
  double initialRotationError = kInitialRotationError;
  /// Expected error of the initial rig's positions, meters.
  double initialPositionError = kInitialPositionError;
  /// Number of rigs from which the solution starts: the initial rig and perturbed copies of it.
  int startCount = 6;
  std::uint64_t seed = 1; ///< random seed for the perturbations
  /// Maximum number of wand positions used, spread evenly over the recording.
  int maxInstants = 900;
};

/// Quality of the solution obtained from one start (the initial rig or a perturbed copy of it).
struct WandStart {
  bool isSolved = false;
  double medianResidualPx = 0.0; ///< median length of the residuals, pixels
};

/// Measurements made during a free fall.
struct FreeFall {
  /// Measured acceleration, meters per second squared; 9.81 if the scale is correct.
  double gravity = 0.0;
  double gravitySigma = 0.0;         ///< standard deviation of `gravity`
  std::size_t usedPositionCount = 0; ///< number of ball positions used
};

/// Output of calibrateFromWand(): the calibrated cameras, and how well the views of the wand fit.
struct WandResult {
  CameraRig cameras; ///< calibrated cameras, with the names of the initial cameras
  /// Offset of each camera, seconds; true time = camera's time + offset.
  std::vector<double> timeOffsets;
  /// Median length of the residuals that were kept, pixels, per camera.
  std::vector<double> cameraMedianResidualPx;
  double medianResidualPx = 0.0;
  std::vector<std::size_t> usedViewCounts;    ///< number of views used, per camera
  std::vector<std::size_t> droppedViewCounts; ///< number of views dropped as outliers, per camera
  std::vector<WandStart> starts;
  WandScale scaleMethod = WandScale::InitialRig;
  double scaleFactor = 1.0; ///< factor by which the size of the initial rig was corrected
  double scaleSigma = 0.0;  ///< relative standard deviation of the scale; 0: unknown
  bool isFloorFound = false;
  double floorRmsDistance =
      0.0; ///< RMS distance of the touched positions from the floor plane, meters
  std::optional<FreeFall> freeFall;
  /// Angle between the upward directions of the initial rig and of the result, radians.
  double upCorrectionAngle = 0.0;
  BundleProblem problem; ///< bundle adjustment problem solved last, in the result's world frame
  BundleResult bundle;   ///< solution of `problem`, with the covariance
  double computationSeconds = 0.0;        ///< computation time, seconds
  std::vector<DetectedFault> faults = {}; ///< mistakes found in the views, such as swapped cameras
};

/// Progress of a calibration by wand.
struct WandProgress {
  int step = 0;
  int stepCount = 0;
  double rmsPx = 0.0; ///< RMS of the residuals, pixels
};
/// Callback for the progress of a calibration by wand. It returns false to stop the computation.
using WandCallback = std::function<bool(const WandProgress&)>;

/// Calibrates the poses of all cameras from a wand (a waved ball or stick), starting from an
/// initial rig. Optionally also calibrates focal lengths, k1 and time offsets. Uses bundle
/// adjustment with robust losses that are narrowed in steps, from several starts. Views that no
/// solution explains are dropped, at most one for each position of the wand per round. The world
/// stays aligned with the initial rig unless floor touches or a fall define the upward direction.
/// Deterministic.
///
/// Fails if a camera has too few views (the error names the camera), if the cameras are not
/// connected by common views, or if fewer than two cameras saw the ball at the time of a touch.
/// Also returns Canceled.
Result<WandResult> calibrateFromWand(const WandProblem& problem,
                                     const WandCallback& callback = nullptr);

} // namespace dewpoint::calibration
