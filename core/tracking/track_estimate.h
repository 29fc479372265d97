// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"
#include "core/filter/gaussian.h"
#include "core/geometry/image_box.h"
#include "core/observation/sphere/camera_evidence.h"

#include <Eigen/Core>

#include <optional>
#include <variant>
#include <vector>

namespace dewpoint::tracking {

/// The estimate of a colored target, a sphere or anything else of which an ellipsoid tells the
/// extent, after one filter iteration. World frame, meters.
struct SphereEstimate {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();       ///< weighted mean (MMSE)
  Eigen::Vector3d best = Eigen::Vector3d::Zero();       ///< particle of highest weight (MAP)
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< m²
  double effectiveSampleSize = 0.0;
  int particleCount = 0;
  int camerasSeeing = 0; ///< cameras with target color at the projected mean
  bool valid = false;    ///< seen by two cameras (by the only one, if there is one)
  /// Something else may be the target about as well, or became the estimate in this frame: the
  /// covariance spans what is known of the others.
  bool ambiguous = false;
  double existenceProbability = 0.0; ///< probability that the target is where the estimate says
  double radius = 0.0; ///< meters, of the target as known or as estimated; 0 when neither
  /// Of a target that is taken for no ball: its extent (m²) as geometry::Ellipsoid has it, and
  /// `radius` is that of a ball of the same volume. Nothing of a ball.
  std::optional<Eigen::Matrix3d> extent;
  /// Position (m, m²) measured in the images of this frame alone, without the prediction; nothing
  /// if the target was not found in them, or the method does not measure it.
  std::optional<Gaussian3> measurement;
  bool degenerate = false; ///< no particle had a usable weight; all were kept as equal
  /// Evidence of each camera for the mean, in the order of the rig; empty when the method has none,
  /// or no position.
  std::vector<CameraEvidence> cameras;
  /// The colors in use in each camera where they follow the light; empty while all cameras use the
  /// target's own.
  std::vector<ColorRanges> colors;
  /// Root mean square distance of the particles to their mean, meters.
  double spread() const;
};

/// The estimate of a bounding box after one image of one camera. Pixels from the upper left corner.
struct BoxEstimate {
  ImageBox box;
  double similarity = 0.0; ///< of the colors in the box to the reference, [0, 1]
  double spread = 0.0;     ///< root mean square distance of the particles to their mean, px
  double effectiveSampleSize = 0.0;
  int particleCount = 0;
  bool visible = true;     ///< false while the target is assumed to be hidden there
  bool degenerate = false; ///< no particle had a usable weight; all were kept as equal
  int camera = 0;          ///< in whose images, in the order of the rig
};

/// The estimate of one person after a frame. World frame, meters.
struct PersonEstimate {
  int identity = 0;                                     ///< from 1 on, never reused in a run
  Eigen::Vector3d position = Eigen::Vector3d::Zero();   ///< mean of the occupied volume
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< of the occupied volume, m²
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();   ///< m/s
  double effectiveSampleSize = 0.0;
  int particleCount = 0;
  int camerasSeeing = 0;             ///< cameras with foreground of this person
  double existenceProbability = 1.0; ///< falls from 1 to 0 while no camera sees the person
  double age = 0.0;                  ///< seconds since the track was created
  bool interacting = false; ///< near another person: what cannot be told apart is not learned
  double height = 0.0;      ///< meters; 0: the method does not estimate it
  /// Hue and saturation of the person, in [0, 1], if the method has them.
  std::optional<Eigen::Vector2d> color;
};

/// The track is not there: a person who has left, a box before the frame in which it was given.
struct AbsentEstimate {};

/// The estimate of a track of any kind. Another kind of target is another alternative: the compiler
/// then reports every visitor that has to handle it.
using TrackEstimate = std::variant<SphereEstimate, BoxEstimate, PersonEstimate, AbsentEstimate>;

bool isAbsent(const TrackEstimate& estimate);
/// Whether the cameras confirm the track now: a valid sphere, a box in sight, a person whose
/// existence is at least one half.
bool isHeld(const TrackEstimate& estimate);
/// Whether something else may be the track about as well.
bool isAmbiguous(const TrackEstimate& estimate);
/// Existence of a sphere or a person; of a box the similarity, which stands for it. 0 when absent.
double existenceProbabilityOf(const TrackEstimate& estimate);
double effectiveSampleSizeOf(const TrackEstimate& estimate);
int particleCountOf(const TrackEstimate& estimate);
/// Mean and covariance in the world (m, m²); nothing for what is known in an image only.
std::optional<Gaussian3> positionOf(const TrackEstimate& estimate);
/// Particle of highest weight (MAP) in the world, meters; nothing where there are no particles, and
/// for kinds of targets that do not tell it (boxes, people).
std::optional<Eigen::Vector3d> bestParticleOf(const TrackEstimate& estimate);
/// The extent (m²) of what is no ball, as geometry::Ellipsoid has it; nothing for all else.
std::optional<Eigen::Matrix3d> extentOf(const TrackEstimate& estimate);
/// Evidence of each camera for the position; empty when the method has none.
const std::vector<CameraEvidence>& cameraEvidenceOf(const TrackEstimate& estimate);
/// Per camera the colors in use where they follow the light; else empty.
const std::vector<ColorRanges>& colorsOf(const TrackEstimate& estimate);

/// The spheres among some estimates, in their order; all else as a sphere of which nothing is
/// known.
std::vector<SphereEstimate> spheresOf(const std::vector<TrackEstimate>& estimates);

} // namespace dewpoint::tracking
