// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/ray.h"
#include "core/observation/sphere/sphere_observation.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::tracking {

/// A place where a target may be, from the images alone.
struct Candidate {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< metres, world
  double radius = 0.0;                              ///< metres
  double logLikelihoodRatio = 0.0;                  ///< SphereEvidence, all cameras
};

/// Looks for targets in whole images: round parts of the target's color in each camera, their rays
/// crossed pair by pair, and, for what only one camera sees, placed by their size.
class CandidateSearch {
public:
  /// A round part of the color in one image.
  struct Spot {
    Ray ray;
    double radiusPx = 0.0;
  };

  explicit CandidateSearch(const CameraRig& rig);

  /// The best places, best first, at most `limit`, no two closer than a radius. A radius of the
  /// observation of 0 means unknown: then it is taken from the images, and the observation is left
  /// with an arbitrary one. Makes the labels of the whole images.
  std::vector<Candidate> find(SphereObservation& observation, bool radiusKnown,
                              std::size_t limit) const;
  /// The first part of it: what is round in one camera's image, all of whose labels are made.
  std::vector<Spot> spotsOf(std::size_t camera, const LabelImage& labels) const;
  /// The second part: the places, from one list of spots per camera.
  std::vector<Candidate> triangulate(const std::vector<std::vector<Spot>>& spots,
                                     SphereObservation& observation, bool radiusKnown,
                                     std::size_t limit) const;

private:
  std::vector<Unprojector> unprojectors_;
  std::vector<double> focals_; ///< pixels
};

} // namespace dewpoint::tracking
