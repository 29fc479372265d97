// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/ancestor_search.h"

#include "core/base/vector_kernel.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>

namespace dewpoint::filter {
namespace {

constexpr int kTileSize = AncestorSearch::kTileSize;

// Half a tile: the compiler's own vector types, which become one register or several of every
// instruction set. It does not find out by itself that the loops below are such operations.
constexpr int kHalf = kTileSize / 2;
using Draws [[gnu::vector_size(kHalf * sizeof(double))]] = double;
using Ranks [[gnu::vector_size(kHalf * sizeof(std::int64_t))]] = std::int64_t;

/// Goes on, tile by tile, until the draws or the particles [begin, end) of this block of weights
/// are used up.
struct TileKernel {
  DEWPOINT_KERNEL void run(const double* __restrict draws, std::int64_t drawCount,
                           const double* __restrict cumulative, std::int64_t begin,
                           std::int64_t end, AncestorSearch::Position* position,
                           std::int32_t* __restrict found) {
    std::int64_t at = position->particle - begin;
    std::int64_t base = position->commonRank;
    std::int64_t first = position->firstDraw;
    Ranks low;
    Ranks high;
    std::memcpy(&low, position->extraRanks.data(), sizeof low);
    std::memcpy(&high, position->extraRanks.data() + kHalf, sizeof high);
    while (first < drawCount) {
      Draws lower;
      Draws upper;
      std::memcpy(&lower, draws + first, sizeof lower);
      std::memcpy(&upper, draws + first + kHalf, sizeof upper);
      const double last = draws[first + kTileSize - 1];
      for (double weight = cumulative[at]; weight <= last; weight = cumulative[++at]) {
        low -= weight <= lower; // true is -1
        high -= weight <= upper;
      }
      if (begin + at == end) {
        break;
      }
      for (int l = 0; l < kHalf; ++l) {
        found[first + l] = static_cast<std::int32_t>(low[l] + base);
        found[first + kHalf + l] = static_cast<std::int32_t>(high[l] + base);
      }
      base = begin + at;
      low = Ranks{};
      high = Ranks{};
      first += kTileSize;
    }
    position->particle = begin + at;
    position->commonRank = base;
    position->firstDraw = first;
    std::memcpy(position->extraRanks.data(), &low, sizeof low);
    std::memcpy(position->extraRanks.data() + kHalf, &high, sizeof high);
  }
};

} // namespace

AncestorSearch::AncestorSearch(const CumulativeWeights& cumulative, const SortedDraws& draws)
    : cumulative_(cumulative), draws_(draws) {}

void AncestorSearch::loadWeights(std::int64_t weightBlock) {
  weightBlock_ = weightBlock;
  const std::int64_t length = cumulative_.writeBlock(weightBlock, weights_.data());
  weights_[std::size_t(length)] = std::numeric_limits<double>::infinity();
  particlesEnd_ = weightBlock * kPrefixBlock + length;
}

std::int64_t AncestorSearch::findAncestors(std::int64_t block, std::int32_t* found) {
  const std::int64_t count = draws_.writeBlock(block, block_.data());
  if (count % kTileSize == 0) {
    searchBlock(count, found);
    return count;
  }
  const std::int64_t padded = (count + kTileSize - 1) / kTileSize * kTileSize;
  std::fill(block_.begin() + count, block_.begin() + padded, block_[std::size_t(count - 1)]);
  std::array<std::int32_t, SortedDraws::kBlockSize> all;
  searchBlock(padded, all.data());
  std::copy_n(all.begin(), count, found);
  return count;
}

void AncestorSearch::searchBlock(std::int64_t drawCount, std::int32_t* found) {
  if (weightBlock_ < 0) {
    loadWeights(cumulative_.blockOfDraw(block_.front()));
    position_.particle = weightBlock_ * kPrefixBlock;
    position_.commonRank = position_.particle;
  }
  position_.firstDraw = 0;
  while (true) {
    runKernel<TileKernel>(static_cast<const double*>(block_.data()), drawCount,
                          static_cast<const double*>(weights_.data()), weightBlock_ * kPrefixBlock,
                          particlesEnd_, &position_, found);
    if (position_.firstDraw == drawCount) {
      return;
    }
    loadWeights(weightBlock_ + 1);
  }
}

} // namespace dewpoint::filter
