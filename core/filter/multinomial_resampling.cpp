// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/multinomial_resampling.h"

#include "core/filter/ancestor_search.h"

#include <cassert>

namespace dewpoint::filter {
namespace {

// Kept for the next call of the same thread: fresh memory costs more than the work on it.
CumulativeWeights& cumulativeWeights() {
  thread_local CumulativeWeights ofThisThread;
  return ofThisThread;
}

void lookUp(const CumulativeWeights& cumulative, Eigen::Index count, const RandomStream& stream,
            ThreadTeam& team, Ancestors& picked) {
  assert(cumulative.total() > 0.0);
  SortedDraws draws(stream, count, cumulative.total());
  picked.resize(static_cast<std::size_t>(count));
  constexpr std::int64_t kBlocksPerWalk = 8;
  constexpr std::int64_t kWalk = kBlocksPerWalk * SortedDraws::kBlockSize;
  team.forEachBlock(count, kWalk, [&](std::int64_t begin, std::int64_t end) {
    AncestorSearch search(cumulative, draws);
    for (; begin < end; begin += SortedDraws::kBlockSize) {
      search.findAncestors(begin / SortedDraws::kBlockSize, picked.data() + begin);
    }
  });
}

} // namespace

void MultinomialResampling::drawAncestors(const BlockWeights& weights, Eigen::Index count,
                                          const RandomStream& stream, ThreadTeam& team,
                                          Ancestors& picked) const {
  CumulativeWeights& cumulative = cumulativeWeights();
  cumulative.compute(weights);
  lookUp(cumulative, count, stream, team, picked);
}

void MultinomialResampling::drawAncestors(const Eigen::ArrayXd& weights, Eigen::Index count,
                                          const RandomStream& stream, Ancestors& picked) const {
  CumulativeWeights& cumulative = cumulativeWeights();
  cumulative.compute(weights);
  ThreadTeam alone(1);
  lookUp(cumulative, count, stream, alone, picked);
}

} // namespace dewpoint::filter
