// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <cstdint>

namespace dewpoint::base {

/// Random number generator Philox4x32-10 (Salmon et al., "Parallel random numbers: as easy as 1, 2,
/// 3", SC 2011). Computes four random words from a counter and a key alone, so the words do not
/// depend on the thread or on the order of computation.
struct Philox {
  using Counter = std::array<std::uint32_t, 4>;
  using Key = std::array<std::uint32_t, 2>;
  static constexpr int kRoundCount = 10;

  /// Replaces the four words `c0` to `c3` of a counter with four random words. `Word` may be a
  /// 64-bit type, which suits vector units with 64-bit multiplication. The upper halves of such
  /// words must be zero at the call, and are not valid afterwards. `Round` is used only by the
  /// function itself.
  template <class Word, int Round = 0>
  [[gnu::always_inline]] static inline void mix(Word& c0, Word& c1, Word& c2, Word& c3,
                                                std::uint32_t key0, std::uint32_t key1) {
    if constexpr (Round < kRoundCount) {
      // Multipliers and key increments from table 2 of the paper.
      const std::uint64_t product0 = std::uint64_t{c0} * std::uint64_t{0xD2511F53};
      const std::uint64_t product1 = std::uint64_t{c2} * std::uint64_t{0xCD9E8D57};
      constexpr std::uint64_t kLowerHalfMask = 0xFFFFFFFF;
      c0 = static_cast<Word>(((product1 >> 32U) ^ c1 ^ key0) & kLowerHalfMask);
      c1 = static_cast<Word>(product1);
      c2 = static_cast<Word>(((product0 >> 32U) ^ c3 ^ key1) & kLowerHalfMask);
      c3 = static_cast<Word>(product0);
      mix<Word, Round + 1>(c0, c1, c2, c3, key0 + 0x9E3779B9U, key1 + 0xBB67AE85U);
    }
  }
};

} // namespace dewpoint::base
