// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/cumulative.h"
#include "core/filter/sorted_draws.h"

#include <array>
#include <cstdint>

namespace dewpoint::filter {

/// Finds the ancestor of each draw: the first particle whose cumulative weight is greater than the
/// draw. The draws are in ascending order, so one pass over both lists gives what std::upper_bound
/// would find for each draw. Each object may be used by one thread only. Several objects may search
/// different draws in parallel.
class AncestorSearch {
public:
  AncestorSearch(const CumulativeWeights& cumulative, const SortedDraws& draws);

  /// Writes the ancestors of one block of draws (from draw SortedDraws::kBlockSize * block on) to
  /// `found` and returns their number. Blocks must be requested in ascending order.
  std::int64_t findAncestors(std::int64_t block, std::int32_t* found);

  /// Number of draws in a tile. All draws of a tile are compared with the same cumulative weight at
  /// the same time.
  static constexpr int kTileSize = 16;
  /// Progress of the search within one tile.
  struct Position {
    std::int64_t firstDraw = 0; ///< first draw of the tile, counted within its block
    std::int64_t particle = 0;  ///< next particle to compare with
    /// Number of particles whose cumulative weight is not above any draw of the tile.
    std::int64_t commonRank = 0;
    /// For each draw, the number of further particles, beyond `commonRank`, whose cumulative weight
    /// is not above the draw.
    std::array<std::int64_t, kTileSize> extraRanks{};
  };

private:
  void searchBlock(std::int64_t drawCount, std::int32_t* found);
  void loadWeights(std::int64_t weightBlock);

  const CumulativeWeights& cumulative_;
  const SortedDraws& draws_;
  std::int64_t weightBlock_ = -1;
  std::int64_t particlesEnd_ = 0; ///< end of the current block of weights
  Position position_;
  std::array<double, kPrefixBlock + 1> weights_; ///< cumulative weights of the block, then infinity
  std::array<double, SortedDraws::kBlockSize> block_;
};

} // namespace dewpoint::filter
