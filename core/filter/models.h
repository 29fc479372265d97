// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/filter/particle_set.h"

#include <Eigen/Core>

#include <concepts>
#include <cstdint>

namespace dewpoint::filter {

/// Motion model, which moves each particle by a random draw from p(X(t) | X(t-1)), where X(t) is
/// the state at time t. `firstIndex` is the index of the first row in the whole set. Random numbers
/// are drawn by particle index, so the result does not depend on how the set is split.
template <class M>
concept MotionModel = requires(const M& model, StateRows rows, std::uint32_t firstIndex,
                               const RandomStream& stream) {
  { model.predict(rows, firstIndex, stream) } -> std::same_as<void>;
};

/// Proposal distribution, which draws new states from a density q(X(t) | X(t-1), observation).
/// propose() also adds log(p / q) to the log weights, where p is the density of the motion model.
template <class P>
concept Proposal = requires(const P& proposal, StateRows rows, LogWeightSegment logWeights,
                            std::uint32_t firstIndex, const RandomStream& stream) {
  { proposal.propose(rows, logWeights, firstIndex, stream) } -> std::same_as<void>;
};

/// Observation model, which adds log p(observation | X) of each particle X to `logLikelihood`.
/// Several threads may call the function at the same time for different particles.
template <class O>
concept ObservationModel = requires(const O& model, ConstStateRows rows,
                                    LogWeightSegment logLikelihood) {
  { model.addLogLikelihood(rows, logLikelihood) } -> std::same_as<void>;
};

/// Resampling method, which picks `count` particles with replacement, so that particle i is picked
/// count * weights[i] times on average. The weights are linear and sum to 1. `ancestors` is resized
/// to `count`. A resampler may also have a second version, which takes BlockWeights as the weights,
/// and a ThreadTeam as an additional argument before `ancestors`. The particle filter then calls
/// this version.
template <class R>
concept Resampler = requires(const R& resampler, const Eigen::ArrayXd& weights, Eigen::Index count,
                             const RandomStream& stream, Ancestors& ancestors) {
  { resampler.drawAncestors(weights, count, stream, ancestors) } -> std::same_as<void>;
};

/// Proposal of the CONDENSATION filter, which draws from the motion model. The log weights stay
/// unchanged, because p / q = 1.
template <MotionModel M> struct MotionProposal {
  M motion;

  void propose(StateRows rows, LogWeightSegment /*logWeights*/, std::uint32_t firstIndex,
               const RandomStream& stream) const {
    motion.predict(rows, firstIndex, stream);
  }
};

} // namespace dewpoint::filter
