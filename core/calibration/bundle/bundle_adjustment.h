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

/// How residuals of gross errors are weighed down (Zach & Bourmaud, ECCV 2018, name them all).
enum class RobustLoss { None, Huber, SoftL1, Cauchy };

/// What was known of a pose before: standard deviations around the start.
struct PosePrior {
  double turnSigma = 0.01;   ///< radians, about each axis of the camera
  double centerSigma = 0.01; ///< meters, along each axis of the world
};

/// One camera of the problem, at its start values, and what of it may change.
struct BundleCamera {
  Camera camera;
  bool poseFixed = false;
  bool focalFree = false;                  ///< both focal lengths, in their present ratio
  bool aspectFree = false;                 ///< the ratio of the focal lengths
  bool centerFree = false;                 ///< the principal point
  std::array<bool, 8> distortionFree = {}; ///< in the order of the camera's lens model
  double offset = 0.0;     ///< seconds, added to the times of its observations to get true times
  bool offsetFree = false; ///< hold one camera's fixed: only differences can be seen
  std::optional<PosePrior> posePrior = std::nullopt;
  double focalPriorSigma = 0.0; ///< relative standard deviation around the start; 0: no prior
};

/// A body whose points are seen.
struct BundleBody {
  enum class Kind {
    Point, ///< one free point
    Stick, ///< two points a known distance apart
    Board  ///< known points, moved as one
  };
  std::string name;
  Kind kind = Kind::Point;
  double length = 0.0;       ///< of a stick, meters
  double lengthSigma = 1e-4; ///< by how much it bends and is misread, each time; meters
  std::vector<Eigen::Vector3d> points = {}; ///< of a board, in its own frame, meters
};

/// A body at an instant: the unknown of the problem beside the cameras.
struct BundleState {
  std::size_t body = 0;
  double time = 0.0;  ///< seconds
  bool known = false; ///< the values below are a start; else points are triangulated (not boards)
  bool fixed = false; ///< the values below are the truth: what defines the world
  std::array<Eigen::Vector3d, 2> ends = {Eigen::Vector3d::Zero(),
                                         Eigen::Vector3d::Zero()}; ///< point (first), stick; meters
  Eigen::Isometry3d worldFromBoard = Eigen::Isometry3d::Identity();
};

/// One image point.
struct BundleObservation {
  std::size_t camera = 0;
  std::size_t state = 0;
  std::size_t point = 0; ///< of the body: 0; 0 or 1 of a stick; index of the board's point
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double sigma = 1.0; ///< standard deviation along each axis, pixels
  double lag = 0.0;   ///< seconds from the state's time to the image's, by the camera's own clock
  /// (R/Z)² for the center of the outline of a ball of radius R at depth Z: that center is the
  /// image of (X, Y, Z (1 - (R/Z)²)), see SphereProjector. 0 for points.
  double outlineShift = 0.0;
  double radius = 0.0; ///< of that outline, pixels; takes no part in the adjustment, 0: not known
};

struct BundleProblem {
  std::vector<BundleCamera> cameras;
  std::vector<BundleBody> bodies;
  std::vector<BundleState> states; ///< of one body: at different times
  std::vector<BundleObservation> observations;
  RobustLoss loss = RobustLoss::None;
  double lossWidth = 2.0; ///< pixels: where the loss begins to differ from squares
  /// Points and sticks are followed between instants through gaps up to this, seconds.
  double longestGap = 0.2;
  int maxIterations = 200;
  /// Ends when the cost changes by less than 1e-5, or after maxIterations, settled or not; no
  /// covariance and no noise factor. For steps on the way.
  bool draft = false;
};

/// What the adjustment found.
struct BundleResult {
  CameraRig cameras;
  std::vector<double> offsets;     ///< seconds, one per camera
  std::vector<BundleState> states; ///< as given, `known` where the solution says where they are
  /// Predicted minus observed, pixels; NaN where an observation could not be used.
  std::vector<Eigen::Vector2d> residuals;
  std::vector<double> cameraRms; ///< pixels, per image point (length of the residual), all used
  double rms = 0.0;              ///< pixels, over all cameras
  std::size_t used = 0;          ///< observations
  /// How many times larger than their sigmas the residuals are (robustly weighted, for the freedoms
  /// left); covariances times its square are what the residuals show.
  double noiseFactor = 1.0;
  BundleCovariance covariance; ///< of the cameras, for the sigmas as given
  int iterations = 0;
  double seconds = 0.0;
};

/// Where a long computation is. Return false to stop it.
struct BundleProgress {
  int iteration = 0;
  double rms = 0.0; ///< pixels, robustly weighted
};
using BundleCallback = std::function<bool(const BundleProgress&)>;

/// Bundle adjustment (Triggs et al. 1999) with Levenberg-Marquardt (Ceres): the cameras and bodies
/// that explain the observations best.
///
/// Where a camera's images are not of the states' instants (offsets, lags), points are followed
/// along the polynomial through up to five neighboring instants, so time offsets are found in the
/// same adjustment. Boards are taken to be at rest. Deterministic: one thread, fixed order.
///
/// Errors, in one sentence: a camera or body without enough observations, geometry that does not
/// determine the cameras, no convergence, senseless numbers, and Cancelled.
Result<BundleResult> adjustBundle(const BundleProblem& problem,
                                  const BundleCallback& callback = nullptr);

} // namespace dewpoint::calibration
