// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace dewpoint::tracking {

/// Assigns numbers from 1 to 4095 to the hypotheses of one track (TrackHypothesis::streamNumber). A
/// target may have two tracks that pass hypotheses to each other. Each track takes its numbers from
/// a separate half of the range, so that no two hypotheses of a target share random numbers or are
/// confused with each other. After the last number of its half, a track continues with the first
/// number. The number 0 is never assigned; it means "no hypothesis".
class HypothesisNumbers {
public:
  /// Half of the range of numbers: for the track that treats the target as a ball (BernoulliTrack),
  /// or for the track that treats it as an object of any shape (RegionTrack).
  enum class Half : std::uint32_t { Ball, Region };

  explicit HypothesisNumbers(Half half) : half_(half) {}

  void restart() { last_ = 0; }
  std::uint32_t next() {
    last_ = last_ % (kHalf - 1) + 1;
    return static_cast<std::uint32_t>(half_) * kHalf + last_;
  }

private:
  /// Size of a half: half of the 4096 numbers available in firstIndex() in track_hypothesis.cpp and
  /// in RandomKey::streamOfPart().
  static constexpr std::uint32_t kHalf = 2048;

  Half half_;
  std::uint32_t last_ = 0; ///< last assigned number within the half; 0: none yet
};

} // namespace dewpoint::tracking
