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

/// What one camera may have wrong: its rotation (rotation vector in camera axes, radians) and its
/// delay (seconds).
struct CameraError {
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  double delay = 0.0;
};

/// An assumption about a rig under which its sightings are explained.
struct AgreementHypothesis {
  /// Whose calibration each camera has; empty: its own.
  std::vector<std::size_t> calibrations = {};
  /// Camera whose rotation or delay is free within wide limits instead of those of any calibration.
  std::optional<std::size_t> freeTurn = {};
  std::optional<std::size_t> freeDelay = {};
  /// Where the search for a delay begins, seconds.
  double initialDelay = 0.0;
};

/// How well an assumption explains what the cameras saw.
struct AgreementFit {
  std::vector<CameraError> errors = {}; ///< the likeliest, one per camera
  /// Natural logarithm of the sightings' likelihood, integrated over the errors, relative to that
  /// of cameras that see unrelated things.
  double logEvidence = 0.0;
  double logLikelihood = 0.0; ///< at `errors`
  double logPrior = 0.0;      ///< of `errors`, relative to none
  double count = 0.0;         ///< sightings that were compared, in sum over their weights
  /// The same by pair of cameras, in the order of pairsOf(): likelihoods and counts.
  std::vector<double> pairLogLikelihoods = {};
  std::vector<double> pairCounts = {};

  /// How well the average sighting is explained of the camera that agrees least with the others:
  /// the mean log likelihood. 0 when nothing was compared.
  double leastMean = 0.0;
};

/// The likelihood of what several cameras saw of the regions of some colors, whichever region is
/// which object: for each sighting that counts and each other camera, a region of the same instant
/// whose ray passes it by, before both cameras and of fitting size, or none. Rays that pass are
/// compared by the sine of the angle between one and the epipolar plane of the other (first-order,
/// "Sampson" normalized by both centers' uncertainty), so that the unit of the rig does not matter.
/// Each camera may be off by what calibrations and clocks usually are, and by what its regions'
/// shapes leave open, which looks like a rotation; these errors are fitted
/// (expectation maximization over the assignment, Gauss-Newton steps), and integrated by Laplace's
/// approximation.
class AgreementModel {
public:
  /// `histories[color][camera]`, as many cameras as the rig has; they must outlive it. `radii`: of
  /// the targets of each color, meters; 0 where it is unknown, and they may be of any shape.
  AgreementModel(const CameraRig& rig, const std::vector<std::vector<SightingHistory>>& histories,
                 std::vector<double> radii);

  AgreementFit fit(const AgreementHypothesis& hypothesis) const;
  /// A rough log likelihood of a camera's delay without fitting anything: of the pairs that it is
  /// in.
  double roughly(std::size_t camera, double delay) const;

  /// The median of measured over known size of the regions that agree under these errors; nothing
  /// from fewer than a few.
  std::optional<double> sizeRatio(const std::vector<CameraError>& errors) const;

  /// Seconds between images, the usual one.
  double interval() const { return interval_; }
  std::size_t cameraCount() const { return cameras_.size(); }
  /// Of cameras, in the order of AgreementFit::pairLogLikelihoods.
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

  /// Of one color in a camera, as seen with the calibration of another one.
  std::vector<Instant> instantsOf(std::size_t color, std::size_t camera,
                                  std::size_t calibration) const;
  /// With cameras that have the calibrations of others.
  Views viewsWith(const std::vector<std::size_t>& calibrations) const;
  /// Of the unknown errors of all cameras, the inverse variances.
  Eigen::VectorXd priorInformation(const AgreementHypothesis& hypothesis, const Views& views) const;
  /// The likelihood under some errors; adds to the normal equations there. By camera times camera.
  AgreementFit evaluated(const Views& views, const std::vector<Pose>& poses,
                         const Eigen::VectorXd& unknowns, double widening, Sums& sums) const;
  void summarizePairs(AgreementFit& fit) const;
  /// Of a camera's sightings that count, the usual bias.
  static double biasOf(const Views& views, std::size_t camera);
  static const Instant* nearest(const std::vector<Instant>& instants, double time, double within);
  /// Visits every comparison: f(a, b, color, weight, share, matches).
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
