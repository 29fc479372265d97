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

/// Error of one camera's calibration or clock: its rotation (rotation vector in camera axes,
/// radians) and its delay (seconds).
struct CameraError {
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  double delay = 0.0;
};

/// Hypothesis about a rig under which its sightings are explained.
struct AgreementHypothesis {
  /// For each camera, the index of the camera whose calibration it has; empty: its own.
  std::vector<std::size_t> calibrations = {};
  /// Camera whose rotation or delay is free within wide limits instead of those usual for
  /// calibrations.
  std::optional<std::size_t> freeTurn = {};
  std::optional<std::size_t> freeDelay = {};
  /// Start value of the search for a delay, in seconds.
  double initialDelay = 0.0;
};

/// How well a hypothesis explains the sightings of the cameras.
struct AgreementFit {
  std::vector<CameraError> errors = {}; ///< most likely errors, one per camera
  /// Natural logarithm of the likelihood of the sightings, integrated over the errors, relative to
  /// cameras that see unrelated objects.
  double logEvidence = 0.0;
  double logLikelihood = 0.0; ///< log likelihood at `errors`
  double logPrior = 0.0;      ///< log prior of `errors`, relative to no errors
  double count = 0.0;         ///< number of sightings that were compared, as a sum of their weights
  /// Log likelihoods and counts by pair of cameras, in the order of AgreementModel::pairs().
  std::vector<double> pairLogLikelihoods = {};
  std::vector<double> pairCounts = {};

  /// Mean log likelihood per sighting of the camera that agrees least with the others; 0 if nothing
  /// was compared.
  double leastMean = 0.0;
};

/// Likelihood of the colored regions that several cameras saw, when it is not known which region is
/// which object.
///
/// For each sighting that counts and each other camera, either one region of the same time belongs
/// to the same object, or none. Such a region has a ray that passes the first ray closely, in front
/// of both cameras, and a matching size. Rays are compared by the sine of the angle between one ray
/// and the epipolar plane of the other (first-order "Sampson" error, normalized by the uncertainty
/// of both centers), so that the unit of the rig does not matter.
///
/// Each camera may have the usual errors of calibrations and clocks, and an error from the shapes
/// of its regions, which looks like a rotation. These errors are fitted (expectation maximization
/// over the assignment, Gauss-Newton steps) and integrated out by Laplace's approximation.
class AgreementModel {
public:
  /// `histories[color][camera]` has as many cameras as the rig, and must outlive the model. `radii`
  /// are those of the targets of each color in meters; 0 if unknown, for targets of any shape.
  AgreementModel(const CameraRig& rig, const std::vector<std::vector<SightingHistory>>& histories,
                 std::vector<double> radii);

  /// Fits the errors of the cameras under a hypothesis.
  AgreementFit fit(const AgreementHypothesis& hypothesis) const;
  /// Rough log likelihood of a camera's delay without fitting anything, from the pairs that contain
  /// the camera.
  double roughly(std::size_t camera, double delay) const;

  /// Median ratio of measured to known size over the regions that agree under these errors; nothing
  /// if there are only a few.
  std::optional<double> sizeRatio(const std::vector<CameraError>& errors) const;

  /// Usual time between images, in seconds.
  double interval() const { return interval_; }
  std::size_t cameraCount() const { return cameras_.size(); }
  /// Pairs of cameras, in the order of AgreementFit::pairLogLikelihoods.
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
    double field = 1.0; ///< angular height of its image, radians
  };
  struct Sums;

  /// Regions of one color in a camera, with rays by the calibration of another camera.
  std::vector<Instant> instantsOf(std::size_t color, std::size_t camera,
                                  std::size_t calibration) const;
  /// Regions of all colors and cameras when each camera has the given calibration.
  Views viewsWith(const std::vector<std::size_t>& calibrations) const;
  /// Inverse prior variances of the unknown errors of all cameras.
  Eigen::VectorXd priorInformation(const AgreementHypothesis& hypothesis, const Views& views) const;
  /// Likelihood at given errors, by camera times camera. Adds to the normal equations at that
  /// point.
  AgreementFit evaluated(const Views& views, const std::vector<Pose>& poses,
                         const Eigen::VectorXd& unknowns, double widening, Sums& sums) const;
  void summarizePairs(AgreementFit& fit) const;
  /// Usual bias of a camera's sightings that count.
  static double biasOf(const Views& views, std::size_t camera);
  static const Instant* nearest(const std::vector<Instant>& instants, double time, double within);
  /// Calls f(a, b, color, weight, share, matches) for every comparison.
  template <class Visit>
  void compare(const Views& views, const std::vector<Pose>& poses,
               const std::vector<CameraError>& errors, double widening,
               std::optional<std::size_t> only, const Visit& visit) const;

  const std::vector<std::vector<SightingHistory>>& histories_;
  std::vector<double> radii_;
  std::vector<Unprojector> unprojectors_; ///< to camera axes
  std::vector<double> focals_;            ///< pixels
  std::vector<Pose> cameras_;
  double interval_ = 0.0;
  Views views_; ///< with their own calibrations
};

} // namespace dewpoint::camera_motion
