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

/// Loss function that reduces the weight of outliers (for an overview see Zach & Bourmaud, ECCV
/// 2018).
enum class RobustLoss { None, Huber, SoftL1, Cauchy };

/// Prior knowledge of a pose: standard deviations around the start value.
struct PosePrior {
  double turnSigma = 0.01;   ///< radians, about each axis of the camera
  double centerSigma = 0.01; ///< meters, along each axis of the world
};

/// A camera of the problem with its start values, and which of its parameters may change.
struct BundleCamera {
  Camera camera;
  bool poseFixed = false;
  bool focalFree = false;                  ///< both focal lengths, with a fixed ratio
  bool aspectFree = false;                 ///< the ratio of the focal lengths
  bool centerFree = false;                 ///< the principal point
  std::array<bool, 8> distortionFree = {}; ///< in the order of the camera's lens model
  double offset = 0.0;     ///< seconds, added to the times of its observations to get true times
  bool offsetFree = false; ///< keep one camera's offset fixed: only differences can be determined
  std::optional<PosePrior> posePrior = std::nullopt;
  double focalPriorSigma = 0.0; ///< relative standard deviation around the start value; 0: no prior
};

/// A body whose points are observed.
struct BundleBody {
  enum class Kind {
    Point, ///< one free point
    Stick, ///< two points a known distance apart
    Board  ///< known points, moved as one
  };
  std::string name;
  Kind kind = Kind::Point;
  double length = 0.0; ///< length of a stick, meters
  double lengthSigma =
      1e-4; ///< standard deviation of the length at each instant (bending, reading errors); meters
  std::vector<Eigen::Vector3d> points = {}; ///< points of a board, in its own frame, meters
};

/// A body at one instant: the unknowns of the problem besides the cameras.
struct BundleState {
  std::size_t body = 0;
  double time = 0.0;  ///< seconds
  bool known = false; ///< whether the values below are a start; if not, points are triangulated
                      ///< (not possible for boards)
  bool fixed = false; ///< the values below are exact and stay fixed: they define the world
  std::array<Eigen::Vector3d, 2> ends = {Eigen::Vector3d::Zero(),
                                         Eigen::Vector3d::Zero()}; ///< point (first), stick; meters
  Eigen::Isometry3d worldFromBoard = Eigen::Isometry3d::Identity();
};

/// One image point.
struct BundleObservation {
  std::size_t camera = 0;
  std::size_t state = 0;
  std::size_t point =
      0; ///< index of the point on the body: 0 for a point; 0 or 1 for a stick; the board's point
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double sigma = 1.0; ///< standard deviation of `pixel` along each axis, pixels
  double lag =
      0.0; ///< seconds from the state's time to the image's time, by the camera's own clock
  /// (R/Z)² if `pixel` is the center of the outline of a ball of radius R at depth Z: that center
  /// is the image of (X, Y, Z (1 - (R/Z)²)), see SphereProjector. 0 for points.
  double outlineShift = 0.0;
  double radius = 0.0; ///< radius of that outline, pixels; not used in the adjustment; 0: not known
};

/// Input of adjustBundle().
struct BundleProblem {
  std::vector<BundleCamera> cameras;
  std::vector<BundleBody> bodies;
  std::vector<BundleState> states; ///< the states of one body have different times
  std::vector<BundleObservation> observations;
  RobustLoss loss = RobustLoss::None;
  double lossWidth = 2.0; ///< residual at which the loss starts to differ from squares, pixels
  /// Largest gap between instants across which points and sticks are interpolated, seconds.
  double longestGap = 0.2;
  int maxIterations = 200;
  /// For intermediate steps: stops when the cost changes by less than 1e-5, or after maxIterations
  /// even without convergence; computes neither covariance nor noise factor.
  bool draft = false;
};

/// Output of adjustBundle().
struct BundleResult {
  CameraRig cameras;
  std::vector<double> offsets; ///< seconds, one per camera
  std::vector<BundleState>
      states; ///< as given, with `known` set where the solution determines them
  /// Predicted minus observed, pixels; NaN for observations that could not be used.
  std::vector<Eigen::Vector2d> residuals;
  std::vector<double> cameraRms; ///< RMS length of the residual of an image point, per camera, over
                                 ///< all used; pixels
  double rms = 0.0;              ///< RMS length over all cameras, pixels
  std::size_t used = 0;          ///< number of observations used
  /// Ratio of the residuals to their sigmas (robustly weighted, corrected for the degrees of
  /// freedom). Multiplying a covariance by its square gives the covariance for the actual
  /// residuals.
  double noiseFactor = 1.0;
  BundleCovariance covariance; ///< of the cameras, for the given sigmas
  int iterations = 0;
  double seconds = 0.0;
};

/// Progress of a long computation. The callback returns false to stop it.
struct BundleProgress {
  int iteration = 0;
  double rms = 0.0; ///< pixels, robustly weighted
};
using BundleCallback = std::function<bool(const BundleProgress&)>;

/// Bundle adjustment (Triggs et al. 1999) with Levenberg-Marquardt (Ceres): finds the cameras and
/// bodies that explain the observations best.
///
/// If the images of a camera were not taken at the times of the states (offsets, lags), the
/// positions of points are interpolated by the polynomial through up to five neighboring instants,
/// so that time offsets are estimated in the same adjustment. Boards are assumed to be at rest.
/// Deterministic: one thread, fixed order.
///
/// Errors, in one sentence: a camera or body without enough observations, geometry that does not
/// determine the cameras, no convergence, senseless numbers, and Canceled.
Result<BundleResult> adjustBundle(const BundleProblem& problem,
                                  const BundleCallback& callback = nullptr);

} // namespace dewpoint::calibration
