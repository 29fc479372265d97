// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/multinomial_resampling.h"

#include "core/filter/ancestor_search.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>

namespace dewpoint {

void MultinomialResampling::ancestors(const Eigen::ArrayXd& weights, Eigen::Index count,
                                      const RandomStream& stream, ThreadTeam& team,
                                      std::vector<Eigen::Index>& picked) const {
  // Kept for the next call of the same thread: fresh memory costs more than the work on it.
  thread_local CumulativeWeights cumulative;
  thread_local SortedDraws draws;
  cumulative.build(weights, team);
  assert(cumulative.total() > 0.0);
  draws.build(stream, count, cumulative.total());
  picked.resize(static_cast<std::size_t>(count));
  const CumulativeWeights& sums = cumulative; // those of this thread, for the others too
  const SortedDraws& sorted = draws;
  constexpr std::int64_t kBlocksPerWalk = 8;
  constexpr std::int64_t kWalk = kBlocksPerWalk * SortedDraws::kBlock;
  team.forEachBlock(count, kWalk, [&](std::int64_t begin, std::int64_t end) {
    AncestorSearch search(sums, sorted);
    std::array<std::int32_t, SortedDraws::kBlock> found;
    for (; begin < end; begin += SortedDraws::kBlock) {
      const std::int64_t length = search.ancestors(begin / SortedDraws::kBlock, found.data());
      std::copy_n(found.begin(), length, picked.begin() + begin);
    }
  });
}

void MultinomialResampling::ancestors(const Eigen::ArrayXd& weights, Eigen::Index count,
                                      const RandomStream& stream,
                                      std::vector<Eigen::Index>& picked) const {
  ThreadTeam alone(1);
  ancestors(weights, count, stream, alone, picked);
}

} // namespace dewpoint
