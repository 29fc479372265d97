// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/ray.h"
#include "core/geometry/world_box.h"
#include "core/observation/sphere/sphere_observation.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// A position at which a target may be, from the images alone.
struct Candidate {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< meters, world
  double radius = 0.0;                              ///< meters
  double logLikelihoodRatio = 0.0;                  ///< SphereEvidence, sum over all cameras
};

/// Searches whole images for targets: finds round spots of the target's color in each camera, and
/// triangulates them pair by pair. A spot of a target of known radius also gives a candidate by
/// itself, whose distance follows from its size.
class CandidateSearch {
public:
  /// A round spot of the color in one image.
  struct Spot {
    Ray ray;               ///< through the spot's center, world frame
    double radiusPx = 0.0; ///< of the inscribed circle
  };

  explicit CandidateSearch(const CameraRig& rig);

  /// The best candidates, best first, at most `limit`, no two closer than a radius. If the radius
  /// is not known, it is estimated from the images, and that of the observation does not matter;
  /// the observation is left with an arbitrary one. None lies outside the bounds. Makes the labels
  /// of the whole images.
  std::vector<Candidate> find(SphereObservation& observation, bool radiusKnown, std::size_t limit,
                              const std::optional<WorldBox>& bounds = std::nullopt) const;
  /// The first step of find(): the spots in one camera's image, all of whose labels are made.
  std::vector<Spot> spotsOf(std::size_t camera, const LabelImage& labels) const;
  /// The second step of find(): the candidates, from one list of spots per camera.
  std::vector<Candidate> triangulate(const std::vector<std::vector<Spot>>& spots,
                                     SphereObservation& observation, bool radiusKnown,
                                     std::size_t limit,
                                     const std::optional<WorldBox>& bounds = std::nullopt) const;

private:
  std::vector<Unprojector> unprojectors_;
  std::vector<double> focals_; ///< pixels
};

} // namespace dewpoint::tracking
