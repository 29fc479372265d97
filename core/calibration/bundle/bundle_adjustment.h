// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/bundle/bundle_covariance.h"
#include "core/geometry/camera.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Loss function of a bundle adjustment that reduces the influence of outliers (for an overview see
/// Zach & Bourmaud, ECCV 2018).
enum class RobustLoss { None, Huber, SoftL1, Cauchy };

/// Prior knowledge of a pose, as standard deviations around the start value.
struct PosePrior {
  double rotationSigma = 0.01; ///< radians, about each camera axis
  double centerSigma = 0.01;   ///< meters, along each world axis
};

/// Camera in a bundle problem: its start values, and which of its parameters may change
/// (`...Free`).
struct BundleCamera {
  Camera camera;
  bool isPoseFixed = false;
  bool isFocalFree = false;  ///< true to adjust both focal lengths together, keeping their ratio
  bool isAspectFree = false; ///< true to adjust the ratio of the focal lengths
  bool isPrincipalPointFree = false; ///< true to adjust the principal point
  /// True for each distortion coefficient to adjust, in the order of the camera's lens model.
  std::array<bool, 8> isDistortionFree = {};
  /// Time offset of the camera, seconds. It is added to the times of the camera's observations to
  /// get true times.
  double timeOffset = 0.0;
  /// True to adjust the camera's time offset. Must be false for at least one camera, because only
  /// differences between offsets can be determined.
  bool isTimeOffsetFree = false;
  std::optional<PosePrior> posePrior = std::nullopt;
  /// Relative standard deviation of the focal length around its start value; 0: no prior.
  double focalPriorSigma = 0.0;
};

/// Body with points that cameras observe.
struct BundleBody {
  enum class Kind {
    Point, ///< one free point
    Stick, ///< two points a known distance apart
    Board  ///< known points that move as a rigid body
  };
  std::string name;
  Kind kind = Kind::Point;
  double length = 0.0; ///< length of a stick, meters
  /// Standard deviation of the stick length at each time, due to bending and reading errors;
  /// meters.
  double lengthSigma = 1e-4;
  std::vector<Eigen::Vector3d> points = {}; ///< points of a board, in the board frame; meters
};

/// Position (and orientation) of a body at one time. The adjustment estimates these states together
/// with the cameras.
struct BundleState {
  std::size_t body = 0;
  double time = 0.0; ///< time at which the body has this position, seconds
  /// True if this state contains a start value for the position of the body. If false, the points
  /// of the body are triangulated, which is not possible for boards.
  bool isPositionKnown = false;
  /// True if the position of the body in this state is exact and stays fixed, so that it defines
  /// the world.
  bool isFixed = false;
  /// Position of the point (first element only), or of both ends of a stick; meters.
  std::array<Eigen::Vector3d, 2> ends = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  Eigen::Isometry3d worldFromBoard = Eigen::Isometry3d::Identity();
};

/// One observed image point.
struct BundleObservation {
  std::size_t camera = 0;
  std::size_t state = 0;
  /// Index of the point on the body: always 0 for a point, 0 or 1 for a stick, and an index in
  /// BundleBody::points for a board.
  std::size_t point = 0;
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double sigma = 1.0; ///< standard deviation of `pixel` along each axis, pixels
  /// Time of the image minus time of the state, by the camera's own clock; seconds.
  double timeAfterState = 0.0;
  /// (R/Z)² if `pixel` is the center of the outline of a ball with radius R at depth Z; 0 if it is
  /// the image of a point. The center of the outline is the image of the point (X, Y, Z (1 -
  /// (R/Z)²)); see SphereProjector.
  double outlineShift = 0.0;
  /// Radius of the outline of the ball, pixels; 0 if unknown; not used in the adjustment.
  double radius = 0.0;
};

/// Input of adjustBundle(): cameras, bodies and the image points observed of them.
struct BundleProblem {
  std::vector<BundleCamera> cameras;
  std::vector<BundleBody> bodies;
  /// Positions of the bodies at each time; states of the same body have different times.
  std::vector<BundleState> states;
  std::vector<BundleObservation> observations;
  RobustLoss loss = RobustLoss::None;
  /// Residual at which the loss starts to deviate from least squares, pixels.
  double lossWidth = 2.0;
  /// Maximum time between two neighboring states, in seconds. Across a longer gap, the positions of
  /// points and sticks are not interpolated.
  double maxStateGapSeconds = 0.2;
  int maxIterations = 200;
  /// True for a quick intermediate result. The adjustment then stops when the cost changes by less
  /// than 1e-5, or after maxIterations even without convergence. The covariance is not computed.
  bool isDraft = false;
};

/// Output of adjustBundle(): the adjusted cameras and bodies, and how well they fit.
struct BundleResult {
  CameraRig cameras;
  /// Offset to add to the times of each camera's observations, seconds.
  std::vector<double> timeOffsets;
  /// The given states with adjusted values; `isPositionKnown` is true where the solution determines
  /// them.
  std::vector<BundleState> states;
  /// Predicted minus observed image point for each observation, pixels; NaN for observations that
  /// could not be used.
  std::vector<Eigen::Vector2d> residuals;
  /// RMS residual length per camera over all used image points, pixels.
  std::vector<double> cameraRmsPx;
  double rmsPx = 0.0;                   ///< RMS residual length over all cameras, pixels
  std::size_t usedObservationCount = 0; ///< number of observations used
  /// Ratio of the residuals to the given sigmas, robustly weighted and corrected for the degrees of
  /// freedom. Multiply `covariance` by the square of this ratio to scale it to the actual size of
  /// the residuals.
  double residualToSigmaRatio = 1.0;
  BundleCovariance covariance; ///< covariance of the cameras, for the given sigmas
  int iterationCount = 0;
  double computationSeconds = 0.0;
};

/// Progress of an adjustment.
struct BundleProgress {
  int iteration = 0;
  double rmsPx = 0.0; ///< RMS residual length, pixels, robustly weighted
};
/// Callback for the progress of a bundle adjustment. It returns false to stop the computation.
using BundleCallback = std::function<bool(const BundleProgress&)>;

/// Finds the cameras and bodies that best explain the observations: bundle adjustment (Triggs et
/// al. 1999) with Levenberg-Marquardt (Ceres).
///
/// Because of time offsets and lags, an image may have been taken between the times of two states.
/// In that case, the positions of points and sticks at the time of the image are interpolated by
/// the polynomial through up to five neighboring states. This makes it possible to estimate the
/// time offsets in the same adjustment. Boards are assumed to be at rest. Deterministic: one
/// thread, fixed order.
///
/// Fails if a camera or body has too few observations, if the observations do not determine the
/// cameras, if the iterations do not converge, or if a number is invalid. Also returns Canceled.
Result<BundleResult> adjustBundle(const BundleProblem& problem,
                                  const BundleCallback& callback = nullptr);

} // namespace dewpoint::calibration
