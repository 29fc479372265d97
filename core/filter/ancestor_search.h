// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/cumulative.h"
#include "core/filter/sorted_draws.h"

#include <array>
#include <cstdint>

namespace dewpoint::filter {

/// The first particle whose cumulative weight is greater than a draw, for draws that rise: what
/// std::upper_bound finds, in one walk along both. Made for one thread; several may walk over parts
/// of the draws.
class AncestorSearch {
public:
  AncestorSearch(const CumulativeWeights& cumulative, const SortedDraws& draws);

  /// Ancestors of draws SortedDraws::kBlock * block and following; returns how many. Blocks in
  /// rising order.
  std::int64_t ancestors(std::int64_t block, std::int32_t* found);

  /// Draws that are compared side by side with one cumulative weight after the other.
  static constexpr int kTile = 16;
  struct Position {
    std::int64_t firstDraw = 0;             ///< of the tile, within its block
    std::int64_t particle = 0;              ///< the next to compare with
    std::int64_t base = 0;                  ///< particles before all draws of the tile
    std::array<std::int64_t, kTile> rank{}; ///< and further ones before each of them, so far
  };

private:
  void walk(std::int64_t drawCount, std::int32_t* found);
  void load(std::int64_t weightBlock);

  const CumulativeWeights& cumulative_;
  const SortedDraws& draws_;
  std::int64_t weightBlock_ = -1;
  std::int64_t particlesEnd_ = 0; ///< of the block of weights
  Position position_;
  std::array<double, kPrefixBlock + 1> weights_; ///< cumulative; infinity behind the last
  std::array<double, SortedDraws::kBlock> block_;
};

} // namespace dewpoint::filter
