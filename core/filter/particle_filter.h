// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/base/thread_team.h"
#include "core/filter/estimate.h"
#include "core/filter/models.h"
#include "core/filter/particle_set.h"

#include <cassert>
#include <cstdint>
#include <utility>
#include <vector>

namespace dewpoint {

/// Which random numbers an iteration draws.
struct RandomKey {
  std::uint64_t seed = 0;
  std::uint32_t frame = 0;
  std::uint32_t iteration = 0; ///< within the frame

  RandomStream stream(RandomPurpose purpose) const { return {seed, frame, iteration, purpose}; }
};

/// A particle filter with resampling at every iteration (CONDENSATION; Barrera et al. 2005, section
/// 2). It owns the particles; the models are handed in. The bits of every result are the same for
/// any number of threads.
class ParticleFilter {
public:
  /// Begins anew with these states, all equally likely. At least one.
  void start(Eigen::ArrayXXd states) {
    assert(states.rows() > 0);
    weighted_.logWeights = Eigen::ArrayXd::Zero(states.rows());
    weights_ = Eigen::ArrayXd::Constant(states.rows(), 1.0 / static_cast<double>(states.rows()));
    weighted_.states = states;
    next_ = std::move(states);
  }

  /// One iteration; the set for the next one is drawn with `nextCount` particles.
  template <Proposal P, ObservationModel O, Resampler R>
  StateEstimate iterate(const P& proposal, const O& observation, const R& resampler,
                        Eigen::Index nextCount, const RandomKey& key, ThreadTeam& team) {
    weigh(proposal, observation, key.stream(RandomPurpose::Motion), team);
    const bool usable = normalize(weighted_.logWeights, weights_, team);
    StateEstimate result = estimate(weighted_.states, weights_, team);
    result.degenerate = !usable;
    resample(resampler, nextCount, key.stream(RandomPurpose::Resampling), team);
    return result;
  }

  /// Redraws the set for the next iteration from the weighted one, with another count.
  template <Resampler R>
  void resize(const R& resampler, Eigen::Index count, const RandomKey& key, ThreadTeam& team) {
    resample(resampler, count, key.stream(RandomPurpose::Resize), team);
  }

  /// The particles as last weighted (before resampling): what estimates are made of.
  const ParticleSet& weighted() const { return weighted_; }
  /// Their linear weights; they sum to 1.
  const Eigen::ArrayXd& weights() const { return weights_; }
  /// The resampled particles, all equally likely, from which the next iteration starts.
  const Eigen::ArrayXXd& next() const { return next_; }

private:
  /// Predicts and weighs block by block, while a block is in the cache.
  template <Proposal P, ObservationModel O>
  void weigh(const P& proposal, const O& observation, const RandomStream& stream,
             ThreadTeam& team) {
    constexpr std::int64_t kBlock = 1024;
    weighted_.states.swap(next_);
    weighted_.logWeights.resize(weighted_.states.rows());
    team.forEachBlock(weighted_.particleCount(), kBlock, [&](std::int64_t begin, std::int64_t end) {
      LogWeightSegment logWeights = weighted_.logWeights.segment(begin, end - begin);
      logWeights.setZero();
      proposal.propose(weighted_.states.middleRows(begin, end - begin), logWeights,
                       static_cast<std::uint32_t>(begin), stream);
      observation.addLogLikelihood(weighted_.states.middleRows(begin, end - begin), logWeights);
    });
  }

  template <Resampler R>
  void resample(const R& resampler, Eigen::Index count, const RandomStream& stream,
                ThreadTeam& team) {
    assert(count > 0);
    if constexpr (requires { resampler.ancestors(weights_, count, stream, team, ancestors_); }) {
      resampler.ancestors(weights_, count, stream, team, ancestors_);
    } else {
      resampler.ancestors(weights_, count, stream, ancestors_);
    }
    next_.resize(count, weighted_.states.cols());
    constexpr std::int64_t kBlock = 4096; // their ancestors stay in the cache for all columns
    team.forEachBlock(count, kBlock, [&](std::int64_t begin, std::int64_t end) {
      for (Eigen::Index column = 0; column < next_.cols(); ++column) {
        const double* from = weighted_.states.col(column).data();
        double* to = next_.col(column).data();
        for (std::int64_t i = begin; i < end; ++i) {
          to[i] = from[ancestors_[static_cast<std::size_t>(i)]];
        }
      }
    });
  }

  ParticleSet weighted_;
  Eigen::ArrayXd weights_;
  Eigen::ArrayXXd next_;
  std::vector<Eigen::Index> ancestors_;
};

} // namespace dewpoint
