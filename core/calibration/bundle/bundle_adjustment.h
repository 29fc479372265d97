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

/// Loss function that reduces the influence of outliers (for an overview see Zach & Bourmaud, ECCV
/// 2018).
enum class RobustLoss { None, Huber, SoftL1, Cauchy };

/// Prior knowledge of a pose, as standard deviations around the start value.
struct PosePrior {
  double rotationSigma = 0.01; ///< radians, about each camera axis
  double centerSigma = 0.01;   ///< meters, along each world axis
};

/// Camera in a bundle problem: its start values, and which of its parameters may change.
struct BundleCamera {
  Camera camera;
  bool poseFixed = false;
  bool focalFree = false;                  ///< both focal lengths, keeping their ratio
  bool aspectFree = false;                 ///< the ratio of the focal lengths
  bool centerFree = false;                 ///< the principal point
  std::array<bool, 8> distortionFree = {}; ///< in the order of the camera's lens model
  double offset =
      0.0; ///< seconds, added to the times of the camera's observations to get true times
  bool offsetFree =
      false; ///< false for at least one camera, because only offset differences can be determined
  std::optional<PosePrior> posePrior = std::nullopt;
  double focalPriorSigma = 0.0; ///< relative standard deviation around the start value; 0: no prior
};

/// Body whose points are observed.
struct BundleBody {
  enum class Kind {
    Point, ///< one free point
    Stick, ///< two points a known distance apart
    Board  ///< known points that move as a rigid body
  };
  std::string name;
  Kind kind = Kind::Point;
  double length = 0.0;       ///< length of a stick, meters
  double lengthSigma = 1e-4; ///< standard deviation of the stick length at each instant (bending,
                             ///< reading errors); meters
  std::vector<Eigen::Vector3d> points = {}; ///< points of a board, in the board frame; meters
};

/// Body at one instant. These states and the cameras are the unknowns of the problem.
struct BundleState {
  std::size_t body = 0;
  double time = 0.0;  ///< seconds
  bool known = false; ///< whether the values below are start values; if not, points are
                      ///< triangulated (not possible for boards)
  bool fixed = false; ///< the values below are exact and stay fixed, so they define the world
  std::array<Eigen::Vector3d, 2> ends = {
      Eigen::Vector3d::Zero(),
      Eigen::Vector3d::Zero()}; ///< the point (first only) or both ends of a stick; meters
  Eigen::Isometry3d worldFromBoard = Eigen::Isometry3d::Identity();
};

/// One observed image point.
struct BundleObservation {
  std::size_t camera = 0;
  std::size_t state = 0;
  std::size_t point = 0; ///< index of the point on the body: 0 for a point; 0 or 1 for a stick;
                         ///< index into the points of a board
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double sigma = 1.0; ///< standard deviation of `pixel` along each axis, pixels
  double lag = 0.0;   ///< time from the state to the image, by the camera's own clock; seconds
  /// (R/Z)² if `pixel` is the center of the outline of a ball with radius R at depth Z; 0 for
  /// points. The center of the outline is the image of (X, Y, Z (1 - (R/Z)²)), see SphereProjector.
  double outlineShift = 0.0;
  double radius = 0.0; ///< radius of that outline, pixels; not used in the adjustment; 0: unknown
};

/// Input of adjustBundle().
struct BundleProblem {
  std::vector<BundleCamera> cameras;
  std::vector<BundleBody> bodies;
  std::vector<BundleState> states; ///< states of the same body have different times
  std::vector<BundleObservation> observations;
  RobustLoss loss = RobustLoss::None;
  double lossWidth =
      2.0; ///< residual at which the loss starts to deviate from least squares, pixels
  /// Largest gap between instants across which points and sticks are interpolated, seconds.
  double longestGap = 0.2;
  int maxIterations = 200;
  /// True for intermediate steps: stops when the cost changes by less than 1e-5, or after
  /// maxIterations even without convergence. Does not compute the covariance or the noise factor.
  bool draft = false;
};

/// Output of adjustBundle().
struct BundleResult {
  CameraRig cameras;
  std::vector<double> offsets; ///< seconds, one per camera
  std::vector<BundleState>
      states; ///< states as given, with `known` set where the solution determines them
  /// Predicted minus observed, pixels; NaN for observations that could not be used.
  std::vector<Eigen::Vector2d> residuals;
  std::vector<double>
      cameraRms;        ///< RMS residual length per camera over all used image points, pixels
  double rms = 0.0;     ///< RMS residual length over all cameras, pixels
  std::size_t used = 0; ///< number of observations used
  /// Ratio of the residuals to their sigmas (robustly weighted, corrected for the degrees of
  /// freedom). Multiplying a covariance by the square of this ratio scales it to the actual
  /// residuals.
  double noiseFactor = 1.0;
  BundleCovariance covariance; ///< covariance of the cameras, for the given sigmas
  int iterations = 0;
  double seconds = 0.0;
};

/// Progress of a long computation. The callback returns false to stop the computation.
struct BundleProgress {
  int iteration = 0;
  double rms = 0.0; ///< pixels, robustly weighted
};
using BundleCallback = std::function<bool(const BundleProgress&)>;

/// Finds the cameras and bodies that best explain the observations: bundle adjustment (Triggs et
/// al. 1999) with Levenberg-Marquardt (Ceres).
///
/// Images of a camera may not have been taken at the times of the states, because of offsets or
/// lags. In that case, point positions are interpolated by the polynomial through up to five
/// neighboring instants, so that time offsets are estimated in the same adjustment. Boards are
/// assumed to be at rest. Deterministic: one thread, fixed order.
///
/// Errors, in one sentence: a camera or body without enough observations, geometry that does not
/// determine the cameras, no convergence, invalid numbers, and Canceled.
Result<BundleResult> adjustBundle(const BundleProblem& problem,
                                  const BundleCallback& callback = nullptr);

} // namespace dewpoint::calibration
