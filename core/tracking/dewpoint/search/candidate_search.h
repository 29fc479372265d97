// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/ray.h"
#include "core/geometry/world_box.h"
#include "core/observation/sphere/sphere_observation.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// Possible position of a target, derived from the images alone.
struct Candidate {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); ///< meters, world frame
  double radius = 0.0;                              ///< meters
  /// Log likelihood ratio (SphereEvidence), summed over all cameras.
  double logLikelihoodRatio = 0.0;
};

/// Searches whole images for targets. Method: find round spots of the target's color in each camera
/// and triangulate pairs of spots from two cameras. If the radius of the target is known, a single
/// spot also gives a candidate, whose distance follows from the size of the spot.
class CandidateSearch {
public:
  /// Round spot of the target's color in one image.
  struct Spot {
    Ray ray;               ///< ray through the center of the spot, world frame
    double radiusPx = 0.0; ///< radius of the inscribed circle, pixels
  };

  explicit CandidateSearch(const CameraRig& rig);

  /// Returns at most `limit` candidates, best first. No two candidates are closer than a radius,
  /// and no candidate is outside the bounds. If `radiusKnown` is false, the radius is estimated
  /// from the images; otherwise it is the radius of the observation. Afterward, the observation has
  /// an arbitrary radius, and all pixels of its images are labeled.
  std::vector<Candidate> find(SphereObservation& observation, bool radiusKnown, std::size_t limit,
                              const std::optional<WorldBox>& bounds = std::nullopt) const;
  /// Returns the spots in one camera's image, which must be fully labeled. This is the first step
  /// of find().
  std::vector<Spot> spotsOf(std::size_t camera, const LabelImage& labels) const;
  /// Returns the candidates from one list of spots per camera. This is the second step of find().
  std::vector<Candidate> triangulate(const std::vector<std::vector<Spot>>& spots,
                                     SphereObservation& observation, bool radiusKnown,
                                     std::size_t limit,
                                     const std::optional<WorldBox>& bounds = std::nullopt) const;

private:
  std::vector<Unprojector> unprojectors_;
  std::vector<double> focals_; ///< focal lengths, pixels
};

} // namespace dewpoint::tracking
