// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera_motion/agreement/region_match.h"
#include "core/camera_motion/agreement/sighting_history.h"
#include "core/geometry/camera.h"
#include "core/geometry/ray.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace dewpoint::camera_motion {

/// Calibration or clock error of one camera: its rotation (rotation vector in camera axes, radians)
/// and its delay (seconds).
struct CameraError {
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  double delay = 0.0;
};

/// Hypothesis about a rig, under which the sightings are explained.
struct AgreementHypothesis {
  /// For each camera, the index of the camera whose calibration it uses. If empty, each camera uses
  /// its own.
  std::vector<std::size_t> calibrations = {};
  /// Camera whose rotation or delay is free within wide limits, rather than the limits that are
  /// usual for calibrations.
  std::optional<std::size_t> freeTurn = {};
  std::optional<std::size_t> freeDelay = {};
  /// Start value for the delay search, in seconds.
  double initialDelay = 0.0;
};

/// How well a hypothesis explains the sightings.
struct AgreementFit {
  std::vector<CameraError> errors = {}; ///< most likely errors, one per camera
  /// Natural logarithm of the likelihood of the sightings, integrated over the errors. It is
  /// relative to the hypothesis that the cameras see unrelated objects.
  double logEvidence = 0.0;
  double logLikelihood = 0.0; ///< log likelihood at `errors`
  double logPrior = 0.0;      ///< log prior of `errors`, relative to no errors
  double count = 0.0;         ///< number of sightings compared, as a sum of their weights
  /// Log likelihoods and counts per camera pair, in the order of AgreementModel::pairs().
  std::vector<double> pairLogLikelihoods = {};
  std::vector<double> pairCounts = {};

  /// Mean log likelihood per sighting of the camera that agrees least with the others; 0 if nothing
  /// was compared.
  double leastMean = 0.0;
};

/// Likelihood of the colored regions seen by several cameras, when it is unknown which region shows
/// which object.
///
/// Each sighting that counts is compared with the regions that each other camera saw at the same
/// time. At most one of them belongs to the same object. Its ray must pass close to the ray of the
/// sighting, in front of both cameras, and its size must match. Rays are compared by the sine of
/// the angle between one ray and the epipolar plane of the other (first-order "Sampson" error,
/// normalized by the uncertainty of both centers), so that the unit of the rig does not matter.
///
/// Each camera may have the errors usual for calibrations and clocks, and an error caused by the
/// shapes of its regions, which looks like a rotation. These errors are fitted (expectation
/// maximization over the assignment, Gauss-Newton steps) and integrated out with Laplace's
/// approximation.
class AgreementModel {
public:
  /// `histories[color][camera]` has as many cameras as the rig, and must outlive the model. `radii`
  /// contains the target radius for each color in meters; 0 if unknown, or for targets of any
  /// shape.
  AgreementModel(const CameraRig& rig, const std::vector<std::vector<SightingHistory>>& histories,
                 std::vector<double> radii);

  /// Fits the camera errors under a hypothesis.
  AgreementFit fit(const AgreementHypothesis& hypothesis) const;
  /// Returns a rough log likelihood of a camera's delay without fitting anything, based on the
  /// pairs that include the camera.
  double roughLogLikelihood(std::size_t camera, double delay) const;

  /// Returns the median ratio of measured to known size over the regions that agree under these
  /// errors. Returns nothing if there are only a few.
  std::optional<double> sizeRatio(const std::vector<CameraError>& errors) const;

  /// Returns the usual time between images, in seconds.
  double interval() const { return interval_; }
  std::size_t cameraCount() const { return cameras_.size(); }
  /// Returns the camera pairs, in the order of AgreementFit::pairLogLikelihoods.
  std::vector<std::pair<std::size_t, std::size_t>> pairs() const;

private:
  struct Instant {
    double time;
    std::vector<SeenRegion> seen;
  };
  using Views = std::vector<std::vector<std::vector<Instant>>>; ///< [color][camera]
  struct Pose {
    Eigen::Vector3d center;
    Eigen::Matrix3d worldFromCamera;
    double field = 1.0; ///< angular height of the camera's image, radians
  };
  struct Sums;

  /// Returns the regions of one color in a camera, with rays computed using the calibration of
  /// camera `calibration`.
  std::vector<Instant> instantsOf(std::size_t color, std::size_t camera,
                                  std::size_t calibration) const;
  /// Returns the regions of all colors and cameras, using the given calibration for each camera.
  Views viewsWith(const std::vector<std::size_t>& calibrations) const;
  /// Returns the inverse prior variances of the unknown errors of all cameras.
  Eigen::VectorXd priorInformation(const AgreementHypothesis& hypothesis, const Views& views) const;
  /// Returns the likelihood at given errors for each pair of cameras. Adds to the normal equations
  /// at that point.
  AgreementFit evaluate(const Views& views, const std::vector<Pose>& poses,
                        const Eigen::VectorXd& unknowns, double widening, Sums& sums) const;
  void summarizePairs(AgreementFit& fit) const;
  /// Returns the usual bias of a camera's sightings that count.
  static double biasOf(const Views& views, std::size_t camera);
  static const Instant* nearest(const std::vector<Instant>& instants, double time, double within);
  /// Calls f(a, b, color, weight, share, matches) for each comparison.
  template <class Visit>
  void compare(const Views& views, const std::vector<Pose>& poses,
               const std::vector<CameraError>& errors, double widening,
               std::optional<std::size_t> only, const Visit& visit) const;

  const std::vector<std::vector<SightingHistory>>& histories_;
  std::vector<double> radii_;
  std::vector<Unprojector> unprojectors_; ///< to camera axes, per camera
  std::vector<double> focals_;            ///< focal lengths, pixels
  std::vector<Pose> cameras_;
  double interval_ = 0.0;
  Views views_; ///< views of the cameras, each with its own calibration
};

} // namespace dewpoint::camera_motion
