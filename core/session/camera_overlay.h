// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::session {

/// An ellipse in an image, pixels; `angle` in radians from +column towards +row.
struct ImageEllipse {
  Eigen::Vector2d center;
  double semiMajor = 0.0;
  double semiMinor = 0.0;
  double angle = 0.0;
};

/// One target as one camera would see it, in pixels of that camera's image.
struct CameraOverlay {
  /// Those in front of the camera; of very many, evenly some.
  std::vector<Eigen::Vector2f> particles;
  std::vector<float> weights; ///< relative to the largest: 0..1
  std::optional<Eigen::Vector2d> estimate;
  std::optional<ImageEllipse> ellipse; ///< 95 % of the projected Gaussian (chi² 5.991, 2 d.o.f.)
  std::optional<ImageEllipse> outline; ///< of the target itself, of what is no ball
  std::optional<Eigen::Vector2d> best; ///< particle of highest weight
  std::optional<Eigen::Vector2d> truth;
  std::optional<ImageBox> box; ///< of methods that follow boxes, then without estimate and ellipse
  bool boxHidden = false;      ///< it is where the target is thought to be
};

/// The distance from the estimate, pixels, within which nine tenths of the weight of the particles
/// lie: the size of what one sees as a cloud, however few light particles are far from it. 0
/// without an estimate or particles.
double cloudRadius(const CameraOverlay& overlay);

/// A position that was considered for a target, as a circle in an image.
struct ProposedOutline {
  Eigen::Vector2d center;
  double radius = 0.0; ///< pixels
  CandidatePosition::Kind kind = CandidatePosition::Kind::Existing;
  double probability = 0.0;
};
std::vector<ProposedOutline> proposedOutlines(const TrackSnapshot& snapshot, int camera,
                                              const TargetSnapshot& target);

/// Projects a target of a snapshot into camera `camera` of its rig.
CameraOverlay cameraOverlay(const TrackSnapshot& snapshot, int camera,
                            const TargetSnapshot& target);

} // namespace dewpoint::session
