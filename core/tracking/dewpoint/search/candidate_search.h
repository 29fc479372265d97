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
  double radius = 0.0;                              ///< radius of the target, meters
  /// Logarithm of the likelihood of the images with the target at `center`, relative to their
  /// likelihood without it, summed over all cameras (SphereEvidence).
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
  /// from the images; otherwise it is the radius set in `observation`. Afterward, `observation` has
  /// an arbitrary radius, and every pixel of its images has a label that tells whether it has the
  /// target's color (PixelLabel).
  std::vector<Candidate> find(SphereObservation& observation, bool radiusKnown, std::size_t limit,
                              const std::optional<WorldBox>& bounds = std::nullopt) const;
  /// Returns the round spots of the target's color in one camera's image, all pixels of which must
  /// be labeled. This is the first step of find(), which searches whole images.
  std::vector<Spot> findSpots(std::size_t camera, const LabelImage& labels) const;
  /// Returns the candidates that result from combining `spots`, which has one list per camera. This
  /// is the second step of find(), which searches whole images.
  std::vector<Candidate> triangulate(const std::vector<std::vector<Spot>>& spots,
                                     SphereObservation& observation, bool radiusKnown,
                                     std::size_t limit,
                                     const std::optional<WorldBox>& bounds = std::nullopt) const;

private:
  std::vector<Unprojector> unprojectors_;
  std::vector<double> focals_; ///< focal lengths, pixels
};

} // namespace dewpoint::tracking
