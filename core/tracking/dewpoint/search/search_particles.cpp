// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/search/search_particles.h"

#include "core/filter/isotropic_motion.h"
#include "core/filter/particle_filter.h"
#include "core/filter/systematic_resampling.h"

namespace dewpoint::tracking {
namespace {

/// Meters per iteration, standard deviation of the random walk along each axis. Origin not
/// recorded; Barrera et al. 2005 use the same.
constexpr double kSearchMotionSigma = 0.03;

void moveInto(const std::optional<WorldBox>& bounds, Eigen::ArrayXXd& states) {
  for (Eigen::Index axis = 0; bounds && axis < 3; ++axis) {
    states.col(axis) = states.col(axis).max(bounds->min[axis]).min(bounds->max[axis]);
  }
}

} // namespace

void SearchParticles::restart(const SearchPrior& prior, Eigen::Index count, const RandomKey& key,
                              const std::optional<WorldBox>& bounds) {
  states_ = prior.drawPositions(count, key.stream(RandomPurpose::Start));
  moveInto(bounds, states_);
  weights_.setConstant(states_.rows(), 1.0 / static_cast<double>(states_.rows()));
}

void SearchParticles::update(const SearchPrior& prior, Eigen::Index count, double radius,
                             const std::optional<WorldBox>& bounds, SphereObservation& observation,
                             const RandomKey& key, ThreadTeam& team) {
  if (states_.rows() != count) {
    restart(prior, count, key, bounds);
  }
  const RandomStream stream = key.stream(RandomPurpose::Search);
  Ancestors ancestors;
  SystematicResampling().drawAncestors(weights_, states_.rows(),
                                       key.streamOfPart(RandomPurpose::Resampling, 0), ancestors);
  states_ = Eigen::ArrayXXd(states_(ancestors, Eigen::all));
  observation.setRadius(radius);
  const IsotropicMotion motion{kSearchMotionSigma};
  team.forEachRange(states_.rows(), [&](std::int64_t begin, std::int64_t end) {
    motion.predict(states_.middleRows(begin, end - begin), static_cast<std::uint32_t>(begin),
                   stream);
  });
  moveInto(bounds, states_);
  const Eigen::ArrayXd logs = observation.logLikelihoods(states_, team);
  normalize(logs, weights_, team);
}

} // namespace dewpoint::tracking
