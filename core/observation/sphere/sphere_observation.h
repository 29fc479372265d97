// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/thread_team.h"
#include "core/filter/particle_set.h"
#include "core/geometry/sphere_image.h"
#include "core/observation/background/label_image.h"
#include "core/observation/sphere/camera_evidence.h"
#include "core/observation/sphere/outline_fit.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace dewpoint::observation {

/// Sphere other than the target that may cover pixels next to the target in the images.
struct OutlineSphere {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< meters, world
  double radius = 0.0;                              ///< meters
};

/// Minimum fraction of the area inside a target's outline that must have the target color for a
/// camera to confirm the target. Chosen by judgment (docs/method-dewpoint.md, section 4).
inline constexpr double kSeenShare = 1.0 / 3.0;
/// Minimum fraction of the area inside a target's outline that must have the target color for the
/// target to count as not covered. Chosen by judgment (docs/method-dewpoint.md, section 8).
inline constexpr double kWholeShare = 0.85;

/// Observation model of the `dewpoint` method, which computes how well the images of all cameras
/// agree with one target, a sphere of one color. States: columns 0 to 2 are x, y, z (meters, world
/// frame), 3 to 5 the velocity (m/s). The velocity is used to move a position to the time of a
/// camera's exposure.
class SphereObservation {
public:
  explicit SphereObservation(const CameraRig& rig);

  std::size_t cameraCount() const { return views_.size(); }
  const SphereProjector& projector(std::size_t camera) const { return views_[camera].projector; }
  LabelImage& labels(std::size_t camera) { return views_[camera].labels; }
  const LabelImage& labels(std::size_t camera) const { return views_[camera].labels; }

  /// Sets the current image of a camera, taken `timeOffset` seconds after the frame's time. The
  /// image, background and classifiers must stay valid until the next call for this camera.
  /// `classifier` tests for the target color in the light of the image, `usual` in the reference
  /// light (BackgroundModel::relativeLight()). If the image is empty, the camera is not used.
  void setImage(std::size_t camera, const cv::Mat& image, double timeOffset,
                const BackgroundModel& background, const ColorClassifier& classifier,
                const ColorClassifier& usual);
  void setImage(std::size_t camera, const cv::Mat& image, double timeOffset,
                const BackgroundModel& background, const ColorClassifier& classifier) {
    setImage(camera, image, timeOffset, background, classifier, classifier);
  }
  /// Sets the radius of the sphere, meters.
  void setRadius(double radius) { radius_ = radius; }
  double radius() const { return radius_; }

  /// Computes the pixel labels (target, background, ...) that addLogLikelihood() needs for these
  /// states. Must not be called while other threads use the model.
  void ensureLabelsFor(ConstStateRows rows);
  /// Adds the log likelihood ratio (SphereEvidence) of each state, summed over the cameras, to
  /// `logLikelihood`.
  void addLogLikelihood(ConstStateRows rows, LogWeightSegment logLikelihood) const;
  /// Returns the log likelihood ratio of each state, like ensureLabelsFor() followed by
  /// addLogLikelihood(), but projects each state only once. The work is distributed over the thread
  /// team.
  Eigen::ArrayXd logLikelihoods(ConstStateRows rows, ThreadTeam& team);

  /// Returns the log likelihood ratio of one position (meters, world), summed over the cameras. The
  /// labels of the pixels are computed as needed.
  double logLikelihoodRatio(const Eigen::Vector3d& center, const Eigen::Vector3d& velocity);
  /// Returns the amount by which logLikelihoodRatio() would increase if color samples that are
  /// covered by other spheres, in the ring around the target's outline, were not counted. In each
  /// camera, only spheres whose projected center lies outside the outline of this target are
  /// considered. A sphere whose center lies inside the outline is the same object, at a position
  /// that was computed from wrongly paired rays. The labels around the position must have been
  /// computed.
  double explainedRingGain(const Eigen::Vector3d& center,
                           const std::vector<OutlineSphere>& others) const;
  /// Returns the log likelihood ratio for the ideal case that the complete target is visible in
  /// every camera into whose image the position projects.
  double fullyVisibleLogLikelihoodRatio(const Eigen::Vector3d& center,
                                        const Eigen::Vector3d& velocity) const;
  /// Returns whether at least one camera shows the rim of the target, at which the target color
  /// ends (SphereEvidence::rimShare()). A part of a larger object of the same color has no rim.
  bool isRimVisible(const Eigen::Vector3d& center, const Eigen::Vector3d& velocity);
  /// Returns the number of cameras with an image into which the position projects.
  int countCamerasInView(const Eigen::Vector3d& center, const Eigen::Vector3d& velocity) const;
  /// Returns the evidence from each camera for a target at one position: the log likelihood ratio
  /// (SphereEvidence), and the fraction of the area inside the outline that has the target color.
  std::vector<CameraEvidence> evidence(const Eigen::Vector3d& center,
                                       const Eigen::Vector3d& velocity);
  /// Returns the number of cameras in which at least the fraction kSeenShare of the sphere's
  /// outline has the target color.
  static int countSeeingCameras(const std::vector<CameraEvidence>& cameras);
  int countSeeingCameras(const Eigen::Vector3d& center, const Eigen::Vector3d& velocity) {
    return countSeeingCameras(evidence(center, velocity));
  }
  /// Fits the outline (fitOutline()) in all cameras that have an image.
  OutlineFit fit(const OutlinePrior& prior, const Eigen::Vector3d& velocity,
                 EdgeSearchRange reach = EdgeSearchRange::Far);

private:
  struct View {
    SphereProjector projector;
    LabelImage labels;
    double timeOffset = 0.0;
    std::vector<SphereImage> outlines; ///< scratch; radius 0: not visible
  };

  /// Returns the outline of the target in the image of a camera for the state in row `row`. The
  /// radius is 0 if this camera provides no evidence.
  SphereImage outlineOf(const View& view, ConstStateRows rows, Eigen::Index row) const;

  std::vector<View> views_;
  double radius_ = 0.0;
};

} // namespace dewpoint::observation
