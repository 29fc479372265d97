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

/// Calibration error and clock error of one camera. `turn` is the rotation by which the camera
/// deviates from its calibration (rotation vector in camera axes, radians), and `delay` is the
/// delay of its images (seconds).
struct CameraError {
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  double delay = 0.0;
};

/// Assumption about the fault of a rig. AgreementModel::fit() computes how well the assumption
/// explains the sightings of colored regions.
struct AgreementHypothesis {
  /// For each camera, the index of the camera whose calibration applies to its images under this
  /// assumption. If empty, each camera has its own calibration.
  std::vector<std::size_t> calibrationIndices = {};
  /// Camera that may point in a wrong direction. The standard deviation of its rotation error is 3
  /// degrees instead of the usual 0.2 degrees.
  std::optional<std::size_t> cameraWithFreeRotation = {};
  /// Camera whose images may be delayed. The standard deviation of its delay is 0.25 s. For other
  /// cameras, it is 0.3 image intervals, as is usual without synchronization.
  std::optional<std::size_t> cameraWithFreeDelay = {};
  /// Start value for the delay of `cameraWithFreeDelay`, in seconds.
  double initialDelay = 0.0;
};

/// How well a hypothesis about a fault of the rig explains the cameras' sightings of colored
/// regions.
struct AgreementFit {
  std::vector<CameraError> errors = {}; ///< most likely errors, one per camera
  /// Natural logarithm of the likelihood of the sightings, integrated over all possible errors,
  /// relative to the likelihood under the hypothesis that the cameras see unrelated objects.
  double logEvidence = 0.0;
  double logLikelihood = 0.0; ///< log likelihood at `errors`
  double logPrior = 0.0;      ///< log prior of `errors`, relative to no errors
  /// Sum of the weights of all comparisons of a sighting with the image of another camera.
  double comparisonCount = 0.0;
  /// Log likelihoods (and then counts of comparisons) for each camera pair, in the order of
  /// AgreementModel::pairs().
  std::vector<double> pairLogLikelihoods = {};
  std::vector<double> pairComparisonCounts = {};

  /// Mean log likelihood per comparison for the camera that agrees least with the others; 0 if
  /// nothing was compared.
  double lowestMeanLogLikelihood = 0.0;
};

/// Model of how likely it is that several cameras see their colored regions where they do, when it
/// is unknown which region shows which object.
///
/// Each sighting that counts (RegionSighting::countsAsEvidence) is compared with the regions that
/// each other camera saw at the same time. At most one of these regions shows the same object. The
/// ray to this region must pass close to the ray of the sighting, in front of both cameras, and the
/// sizes must match. Rays are compared by the sine of the angle between one ray and the epipolar
/// plane of the other ray, so that the unit of the rig does not matter. This is the first-order
/// ("Sampson") error, normalized by the uncertainty of both centers.
///
/// Each camera may have the errors that are usual for calibrations and clocks. In addition, it may
/// have an error that is caused by the shapes of its regions and looks like a rotation. All these
/// errors are fitted (expectation maximization over the assignment, Gauss-Newton steps) and
/// integrated out with Laplace's approximation.
class AgreementModel {
public:
  /// Creates a model of the sightings in `histories[color][camera]`. `histories` must have as many
  /// cameras as the rig, and must outlive the model. `radii` contains, for each color, the radius
  /// of the targets in meters, or 0 if the radius is unknown or the targets are not balls.
  AgreementModel(const CameraRig& rig, const std::vector<std::vector<SightingHistory>>& histories,
                 std::vector<double> radii);

  /// Fits the errors of all cameras under a hypothesis, and returns how well the hypothesis
  /// explains the sightings.
  AgreementFit fit(const AgreementHypothesis& hypothesis) const;
  /// Returns a rough log likelihood of the sightings if the images of a camera are delayed by
  /// `delay` (seconds). Fits no errors, and uses only the pairs of cameras that include this
  /// camera.
  double approximateLogLikelihood(std::size_t camera, double delay) const;

  /// Returns the median ratio of the measured to the known radius of targets. The median is taken
  /// over the regions that match between cameras with the errors `errors`. Returns nothing if only
  /// a few regions match.
  std::optional<double> sizeRatio(const std::vector<CameraError>& errors) const;

  /// Returns the median time between successive images of a camera, in seconds.
  double imageInterval() const { return imageInterval_; }
  std::size_t cameraCount() const { return cameras_.size(); }
  /// Returns the camera pairs, in the order of AgreementFit::pairLogLikelihoods.
  std::vector<std::pair<std::size_t, std::size_t>> pairs() const;

private:
  /// Regions of one color in one image, and the time of that image in seconds.
  struct RegionImage {
    double time;
    std::vector<SeenRegion> regions;
  };
  /// Images and their regions, by color and camera.
  using Views = std::vector<std::vector<std::vector<RegionImage>>>;
  struct Pose {
    Eigen::Vector3d center;
    Eigen::Matrix3d worldFromCamera;
    double verticalFieldOfView = 1.0; ///< angular height of the camera's image, radians
  };
  struct Sums;

  /// Returns the images of a camera with the regions of one color. The rays to the regions are
  /// computed with the calibration of the camera `calibration`.
  std::vector<RegionImage> regionImagesOf(std::size_t color, std::size_t camera,
                                          std::size_t calibration) const;
  /// Returns the images and regions of all colors and cameras. Camera k uses the calibration of
  /// camera `calibrations[k]`.
  Views viewsWith(const std::vector<std::size_t>& calibrations) const;
  /// Returns the inverse prior variances of the errors of all cameras: three rotations and a delay
  /// for each.
  Eigen::VectorXd priorInformation(const AgreementHypothesis& hypothesis, const Views& views) const;
  /// Computes the log likelihoods of all pairs of cameras at the errors `unknowns`, and adds the
  /// normal equations at these errors to `sums`. `widening` is an additional uncertainty of all
  /// directions, in radians.
  AgreementFit evaluate(const Views& views, const std::vector<Pose>& poses,
                        const Eigen::VectorXd& unknowns, double widening, Sums& sums) const;
  void summarizePairs(AgreementFit& fit) const;
  /// Returns the median constant error due to region shape (SeenRegion::biasSigma), over those
  /// sightings of a camera that count as evidence.
  static double biasOf(const Views& views, std::size_t camera);
  /// Returns the image in `instants` that is closest to `time`, or null if none is within `within`
  /// seconds of `time`.
  static const RegionImage* nearest(const std::vector<RegionImage>& instants, double time,
                                    double within);
  /// Calls visit(a, b, color, seen, other, rotations, matches, likelihood) for each comparison of a
  /// region `seen`, which counts in camera `a`, with the image `other` of camera `b`. `rotations`
  /// contains the world-from-camera rotations with the errors applied. `matches` has one entry per
  /// region in `other`; the `relativeLikelihood` of an entry is the probability that the region
  /// shows the same object as `seen`. With `only`, only pairs that include this camera are
  /// compared.
  template <class Visit>
  void compare(const Views& views, const std::vector<Pose>& poses,
               const std::vector<CameraError>& errors, double widening,
               std::optional<std::size_t> only, const Visit& visit) const;

  const std::vector<std::vector<SightingHistory>>& histories_;
  std::vector<double> radii_;
  /// Converters from pixels to directions in camera axes, one per camera.
  std::vector<Unprojector> unprojectors_;
  std::vector<double> focals_; ///< focal length of each camera, pixels
  std::vector<Pose> cameras_;
  double imageInterval_ = 0.0;
  Views views_; ///< images and regions of all cameras, each with its own calibration
};

} // namespace dewpoint::camera_motion
