// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::session {

/// Ellipse in an image, in pixels. `angleRadians` is the direction of the major axis in radians,
/// measured from the x axis (to the right) toward the y axis (down).
struct ImageEllipse {
  Eigen::Vector2d center;
  double semiMajorAxis = 0.0;
  double semiMinorAxis = 0.0;
  double angleRadians = 0.0;
};

/// Projection of one target into the image of one camera, in pixels.
struct CameraOverlay {
  /// Projections of the particles in front of the camera; an even selection if there are very many.
  std::vector<Eigen::Vector2f> particles;
  /// Weights of these particles, relative to the largest weight: 0 to 1.
  std::vector<float> weights;
  std::optional<Eigen::Vector2d> estimate;
  /// Projected uncertainty of the position: ellipse that contains the target with a probability of
  /// 95 % (chi² 5.991, 2 d.o.f.).
  std::optional<ImageEllipse> ellipse;
  std::optional<ImageEllipse> outline; ///< projected outline of a target that is not a ball
  std::optional<Eigen::Vector2d>
      bestParticle; ///< projection of the particle with the highest weight
  std::optional<Eigen::Vector2d> truth;
  /// Bounding box, for methods that track boxes in the image. `estimate` and `ellipse` are then
  /// empty.
  std::optional<ImageBox> box;
  bool isBoxHidden = false; ///< the target is hidden; the box is at its estimated position
};

/// Returns the radius of the particle cloud in the image, in pixels: the distance from the estimate
/// within which 90 % of the particle weight lies. Returns 0 if there is no estimate or no particle.
double cloudRadius(const CameraOverlay& overlay);

/// Candidate position of a target, as a circle in a camera image.
struct ProposedOutline {
  Eigen::Vector2d center;
  double radius = 0.0; ///< radius of the circle, pixels
  CandidatePosition::Kind kind = CandidatePosition::Kind::Existing;
  double probability = 0.0;
};
/// Returns the candidate positions of a target, projected into the image of camera number `camera`.
std::vector<ProposedOutline> proposedOutlines(const TrackSnapshot& snapshot, int camera,
                                              const TargetSnapshot& target);

/// Returns the projection of a target into the image of camera number `camera` of the snapshot's
/// rig.
CameraOverlay cameraOverlay(const TrackSnapshot& snapshot, int camera,
                            const TargetSnapshot& target);

} // namespace dewpoint::session
