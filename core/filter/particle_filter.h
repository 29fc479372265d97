// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/base/thread_team.h"
#include "core/filter/block_weights.h"
#include "core/filter/estimate.h"
#include "core/filter/models.h"
#include "core/filter/moments.h"
#include "core/filter/particle_set.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace dewpoint::filter {

/// Key for the random numbers of one iteration. Equal keys give equal numbers.
struct RandomKey {
  std::uint64_t seed = 0;
  std::uint32_t frame = 0;
  std::uint32_t iteration = 0; ///< iteration number within the frame

  RandomStream stream(RandomPurpose purpose) const { return {seed, frame, iteration, purpose}; }

  /// Returns the random stream of one part of a computation. In each iteration, up to 4096 parts
  /// (numbered from 0) may draw numbers for the same purpose. Within 2^20 iterations of a frame, no
  /// two parts share a stream.
  RandomStream streamOfPart(RandomPurpose purpose, std::uint32_t part) const {
    // The part number is stored between the low and the high bits of the iteration.
    return {seed, frame, (iteration & 0xFFU) | (part << 8U) | (iteration >> 8U) << 20U, purpose};
  }
};

/// Particle filter that resamples at every iteration (CONDENSATION; Barrera et al. 2005, section
/// 2). The filter owns the particles; the models are passed to each call. All results are
/// bit-identical for any number of threads.
///
/// With many particles, memory access takes most of the time, so each state is written once per
/// iteration. Resampling only stores the index of each particle's ancestor. The next iteration
/// copies the states of the ancestors, moves, weighs and sums them, block by block, so that each
/// block stays in the cache.
class ParticleFilter {
public:
  /// Restarts with the given states, which get equal weights. At least one state is required.
  void start(Eigen::ArrayXXd states) {
    assert(states.rows() > 0);
    states_ = std::move(states);
    ancestors_.resize(static_cast<std::size_t>(states_.rows()));
    std::iota(ancestors_.begin(), ancestors_.end(), 0);
    weights_.resize(states_.rows());
    weights_.makeEqual();
  }

  /// Runs one iteration, draws `nextParticleCount` particles for the next iteration, and returns
  /// the estimate.
  template <Proposal P, ObservationModel O, Resampler R>
  StateEstimate iterate(const P& proposal, const O& observation, const R& resampler,
                        Eigen::Index nextParticleCount, const RandomKey& key, ThreadTeam& team) {
    weigh(proposal, observation, key.stream(RandomPurpose::Motion), team);
    const bool usable = weights_.normalize();
    StateEstimate result = estimateWeighted(usable);
    resample(resampler, nextParticleCount, key.stream(RandomPurpose::Resampling), team);
    return result;
  }

  /// Changes the number of particles in the next iteration to `count`, by drawing the particles of
  /// the next iteration again from the weighted particles.
  template <Resampler R>
  void resize(const R& resampler, Eigen::Index count, const RandomKey& key, ThreadTeam& team) {
    resample(resampler, count, key.stream(RandomPurpose::Resize), team);
  }

  /// Returns the particles that were weighted last, before resampling. Estimates are computed from
  /// these particles.
  const Eigen::ArrayXXd& states() const { return states_; }
  /// Returns the linear weights of states(), which sum to 1.
  const BlockWeights& weights() const { return weights_; }
  /// Returns the number of particles in the next iteration.
  Eigen::Index nextParticleCount() const { return static_cast<Eigen::Index>(ancestors_.size()); }
  /// Returns the resampled particles, equally weighted, with which the next iteration starts.
  Eigen::ArrayXXd next() const { return states_(ancestors_, Eigen::all); }

private:
  /// Predicts and weighs the particles, and computes their mean and scatter. All this is done block
  /// by block, while a block is in the cache.
  template <Proposal P, ObservationModel O>
  void weigh(const P& proposal, const O& observation, const RandomStream& stream,
             ThreadTeam& team) {
    const Eigen::Index count = nextParticleCount();
    parents_.swap(states_);
    states_.resize(count, parents_.cols());
    weights_.resize(count);
    moments_.resize(static_cast<std::size_t>((count + kSumBlock - 1) / kSumBlock));
    team.forEachBlock(count, kSumBlock, [&](std::int64_t begin, std::int64_t end) {
      const std::int64_t length = end - begin;
      copyFromParents(begin, end);
      std::array<double, kSumBlock> buffer;
      Eigen::Map<Eigen::ArrayXd> logWeights(buffer.data(), length);
      logWeights.setZero();
      proposal.propose(states_.middleRows(begin, length), logWeights,
                       static_cast<std::uint32_t>(begin), stream);
      observation.addLogLikelihood(states_.middleRows(begin, length), logWeights);
      weights_.setBlock(begin, length, buffer.data());
      moments_[std::size_t(begin / kSumBlock)] =
          measureMoments(states_, weights_.relativeWeightsFrom(begin), begin, end);
    });
  }

  void copyFromParents(std::int64_t begin, std::int64_t end) {
    Eigen::Index column = 0;
    for (; column + 3 <= states_.cols(); column += 3) {
      copyColumns<3>(column, begin, end);
    }
    for (; column < states_.cols(); ++column) {
      copyColumns<1>(column, begin, end);
    }
    prefetchParents(end, std::min(end + kSumBlock, nextParticleCount()));
  }

  template <int Columns>
  void copyColumns(Eigen::Index column, std::int64_t begin, std::int64_t end) {
    const double* from = parents_.col(column).data();
    double* to = states_.col(column).data();
    const Eigen::Index fromStride = parents_.rows();
    const Eigen::Index toStride = states_.rows();
    const std::int32_t* ancestors = ancestors_.data();
    for (std::int64_t i = begin; i < end; ++i) {
      const double* parent = from + ancestors[i];
      for (int c = 0; c < Columns; ++c) {
        to[c * toStride + i] = parent[c * fromStride];
      }
    }
  }

  /// Prefetches the memory of the next block while the current one is processed.
  [[gnu::always_inline]] void prefetchParents(std::int64_t begin, std::int64_t end) {
    constexpr std::int64_t kLine = 8; // numbers per cache line
    for (Eigen::Index column = 0; column < states_.cols(); ++column) {
      const double* from = parents_.col(column).data();
      double* to = states_.col(column).data();
      for (std::int64_t i = begin; i < end; i += kLine) {
        __builtin_prefetch(from + ancestors_[static_cast<std::size_t>(i)]);
        __builtin_prefetch(to + i, 1);
      }
    }
  }

  StateEstimate estimateWeighted(bool usable) {
    Moments all;
    for (std::size_t block = 0; block < moments_.size(); ++block) {
      const auto begin = static_cast<std::int64_t>(block) * kSumBlock;
      if (!usable) { // normalize() has changed all weights
        const std::int64_t end = std::min(begin + kSumBlock, weights_.particleCount());
        moments_[block] = measureMoments(states_, weights_.relativeWeightsFrom(begin), begin, end);
      }
      all.add(moments_[block], weights_.blockFactor(begin / kSumBlock));
    }
    StateEstimate result = estimateFrom(std::move(all));
    result.isDegenerate = !usable;
    return result;
  }

  template <Resampler R>
  void resample(const R& resampler, Eigen::Index count, const RandomStream& stream,
                ThreadTeam& team) {
    assert(count > 0);
    if constexpr (requires {
                    resampler.drawAncestors(weights_, count, stream, team, ancestors_);
                  }) {
      resampler.drawAncestors(weights_, count, stream, team, ancestors_);
    } else {
      resampler.drawAncestors(weights_.linearWeights(), count, stream, ancestors_);
    }
  }

  Eigen::ArrayXXd states_;
  BlockWeights weights_; ///< weights of `states_`
  Ancestors
      ancestors_; ///< index in `states_` of the ancestor of each particle in the next iteration
  Eigen::ArrayXXd parents_;
  std::vector<Moments> moments_; ///< one entry per block
};

} // namespace dewpoint::filter
