// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/thread_team.h"
#include "core/filter/particle_filter.h"
#include "core/observation/sphere/sphere_observation.h"
#include "core/tracking/dewpoint/search/search_prior.h"

#include <Eigen/Core>

#include <optional>

namespace dewpoint::tracking {

/// Particles that show, in the views, where a target without a confirmed position is searched for.
/// They come from a particle filter with a random walk. No hypothesis about the target depends on
/// these particles.
class SearchParticles {
public:
  /// Draws `count` particles with equal weights from the prior. Particles outside the bounds are
  /// moved to the nearest point inside.
  void restart(const SearchPrior& prior, Eigen::Index count, const RandomKey& key,
               const std::optional<WorldBox>& bounds);
  /// Resamples and moves the particles, and weights them with the images of a frame, for a sphere
  /// of `radius` meters. Draws new particles if their number is not `count`.
  void update(const SearchPrior& prior, Eigen::Index count, double radius,
              const std::optional<WorldBox>& bounds, SphereObservation& observation,
              const RandomKey& key, ThreadTeam& team);

  /// Returns the positions of the particles as rows of x, y, z; meters, world frame.
  const Eigen::ArrayXXd& states() const { return states_; }
  /// Returns the linear weights of the particles, which sum to 1.
  const Eigen::ArrayXd& weights() const { return weights_; }

private:
  Eigen::ArrayXXd states_;
  Eigen::ArrayXd weights_;
};

} // namespace dewpoint::tracking
