// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"
#include "core/filter/gaussian.h"
#include "core/geometry/image_box.h"
#include "core/observation/sphere/camera_evidence.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

namespace dewpoint::tracking {

/// Returns the root mean square distance from the mean, in meters, of a position with this
/// covariance (m²).
double spreadOf(const Eigen::Matrix3d& covariance);

/// Estimate of a colored target after one filter iteration. The target is a sphere, or an object
/// whose extent is given by an ellipsoid. World frame, meters.
struct SphereEstimate {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();       ///< weighted mean (MMSE)
  Eigen::Vector3d best = Eigen::Vector3d::Zero();       ///< particle of highest weight (MAP)
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< covariance of the position, m²
  double effectiveSampleSize = 0.0;
  int particleCount = 0;
  /// Number of cameras that show the color of the target at the projected mean.
  int seeingCameraCount = 0;
  bool isValid = false; ///< true if at least two cameras, or the only camera, confirm the target
  /// True if another object is about as likely to be the target, or if the estimate moved to
  /// another object in this frame. The covariance then also covers the other candidates.
  bool isAmbiguous = false;
  double existenceProbability = 0.0; ///< probability that the target is at the estimate
  double radius = 0.0;               ///< meters, given or estimated; 0 if unknown
  /// Extent (m²) of a target that is not a ball, as in geometry::Ellipsoid; `radius` is then the
  /// radius of a ball of the same volume. Empty for a ball.
  std::optional<Eigen::Matrix3d> extent;
  /// Position (m, m²) measured in the images of this frame alone, without the prediction. Empty if
  /// the target was not found in the images, or if the method does not measure positions.
  std::optional<Gaussian3> measurement;
  bool isDegenerate = false; ///< no particle had a usable weight; all weights were set equal
  /// Likelihood, existence probability and visible fraction at the mean for each camera, in the
  /// order of the cameras in the rig. Empty if the method does not compute these values or the
  /// position is unknown.
  std::vector<CameraEvidence> cameras;
  /// Colors in use in each camera if they adapt to the light; empty while all cameras use the
  /// colors of the target.
  std::vector<ColorRanges> colors;
  /// Returns the root mean square distance of the particles from their mean, in meters.
  double spread() const;
};

/// Estimate of a bounding box after one image of one camera, in pixels from the upper left corner.
struct BoxEstimate {
  ImageBox box;
  double similarity = 0.0;   ///< similarity of the colors in the box to the reference, [0, 1]
  double spreadPixels = 0.0; ///< root mean square distance of the particles from their mean
  double effectiveSampleSize = 0.0;
  int particleCount = 0;
  bool isVisible = true;     ///< false while the target is assumed to be hidden
  bool isDegenerate = false; ///< no particle had a usable weight; all weights were set equal
  int camera = 0;            ///< camera index in the rig
};

/// Estimate of one person after a frame. World frame, meters.
struct PersonEstimate {
  int identity = 0; ///< number of the person, from 1 on, never reused in a run
  Eigen::Vector3d position = Eigen::Vector3d::Zero();   ///< mean of the occupied volume
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< covariance of the occupied volume, m²
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();   ///< m/s
  double effectiveSampleSize = 0.0;
  int particleCount = 0;
  int seeingCameraCount = 0;         ///< number of cameras with foreground of this person
  double existenceProbability = 1.0; ///< falls from 1 to 0 while no camera sees the person
  double ageSeconds = 0.0;           ///< seconds since the track was created
  /// True if another person is near. The method then learns nothing from image content that may
  /// belong to either of the two.
  bool isInteracting = false;
  double height = 0.0; ///< meters; 0 if the method does not estimate it
  /// Hue and saturation of the person, in [0, 1], if the method estimates them.
  std::optional<Eigen::Vector2d> hueAndSaturation;
};

/// No estimate: the person has left, or the box has not yet been defined in this frame.
struct AbsentEstimate {};

/// Estimate of a track of any kind. For a new kind of target, add an alternative; the compiler then
/// reports every visitor that must handle it.
using TrackEstimate = std::variant<SphereEstimate, BoxEstimate, PersonEstimate, AbsentEstimate>;

/// Returns whether the track has no estimate.
bool isAbsent(const TrackEstimate& estimate);
/// Returns whether the cameras confirm the track now: a valid sphere, a visible box, or a person
/// with an existence probability of at least one half.
bool isConfirmed(const TrackEstimate& estimate);
/// Returns whether another object is about as likely to be the target.
bool isAmbiguous(const TrackEstimate& estimate);
/// Returns the existence probability of a sphere or a person, the similarity of a box, or 0 if the
/// estimate is absent.
double existenceProbabilityOf(const TrackEstimate& estimate);
/// Returns the effective sample size of the particles, or 0 if the estimate is absent.
double effectiveSampleSizeOf(const TrackEstimate& estimate);
/// Returns the number of particles, or 0 if the estimate is absent.
int particleCountOf(const TrackEstimate& estimate);
/// Returns the mean and covariance of the position in the world frame (m, m²), or nothing if the
/// position is known only in an image.
std::optional<Gaussian3> positionOf(const TrackEstimate& estimate);
/// Returns the velocity (m/s) of a person in the world frame; nothing for other kinds, whose
/// methods do not estimate it.
std::optional<Eigen::Vector3d> velocityOf(const TrackEstimate& estimate);
/// Returns the identity of a person. Returns the number of the track, from 1 on, for other kinds.
/// `track` is the index of the track, from 0 on.
int identityOf(const TrackEstimate& estimate, std::size_t track);
/// Returns the particle of highest weight (MAP) in the world frame, meters. Returns nothing for
/// boxes and people, and if there are no particles.
std::optional<Eigen::Vector3d> bestParticleOf(const TrackEstimate& estimate);
/// Returns the extent (m²) of a target that is not a ball, as in geometry::Ellipsoid. Returns
/// nothing for a ball, a box or a person.
std::optional<Eigen::Matrix3d> extentOf(const TrackEstimate& estimate);
/// Returns the likelihood, existence probability and visible fraction for each camera at the
/// estimated position. The list is empty if the method does not compute these values.
const std::vector<CameraEvidence>& cameraEvidenceOf(const TrackEstimate& estimate);
/// Returns the colors in use in each camera if they adapt to the light, otherwise an empty list.
const std::vector<ColorRanges>& colorsOf(const TrackEstimate& estimate);

/// Returns the estimates as spheres, in the same order. Estimates of other kinds become empty
/// SphereEstimates.
std::vector<SphereEstimate> spheresOf(const std::vector<TrackEstimate>& estimates);

} // namespace dewpoint::tracking
