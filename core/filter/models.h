// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/filter/particle_set.h"

#include <Eigen/Core>

#include <concepts>
#include <cstdint>

namespace dewpoint::filter {

/// Moves particles by p(X(t) | X(t-1)). `firstIndex` is the index of the first row within the whole
/// set: random numbers are drawn by particle index, so that it does not matter how the set is cut.
template <class M>
concept MotionModel = requires(const M& model, StateRows rows, std::uint32_t firstIndex,
                               const RandomStream& stream) {
  { model.predict(rows, firstIndex, stream) } -> std::same_as<void>;
};

/// Draws new states from q(X(t) | X(t-1), observation) and adds log(p / q) to the log weights,
/// where p is the motion model's density.
template <class P>
concept Proposal = requires(const P& proposal, StateRows rows, LogWeightSegment logWeights,
                            std::uint32_t firstIndex, const RandomStream& stream) {
  { proposal.propose(rows, logWeights, firstIndex, stream) } -> std::same_as<void>;
};

/// Adds log p(observation | X) of each particle to `logLikelihood`. Called from several threads at
/// once, for different particles.
template <class O>
concept ObservationModel = requires(const O& model, ConstStateRows rows,
                                    LogWeightSegment logLikelihood) {
  { model.addLogLikelihood(rows, logLikelihood) } -> std::same_as<void>;
};

/// Picks `count` particles, with repetition, so that particle i is expected count * weights[i]
/// times (weights linear, summing to 1). `ancestors` is resized to `count`. A resampler that takes
/// BlockWeights, and a ThreadTeam before `ancestors`, is given the filter's.
template <class R>
concept Resampler = requires(const R& resampler, const Eigen::ArrayXd& weights, Eigen::Index count,
                             const RandomStream& stream, Ancestors& ancestors) {
  { resampler.ancestors(weights, count, stream, ancestors) } -> std::same_as<void>;
};

/// The proposal of CONDENSATION: the motion model itself, so p / q = 1.
template <MotionModel M> struct MotionProposal {
  M motion;

  void propose(StateRows rows, LogWeightSegment /*logWeights*/, std::uint32_t firstIndex,
               const RandomStream& stream) const {
    motion.predict(rows, firstIndex, stream);
  }
};

} // namespace dewpoint::filter
