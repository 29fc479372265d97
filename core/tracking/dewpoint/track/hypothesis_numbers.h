// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace dewpoint::tracking {

/// Numbers the hypotheses of one track (TrackHypothesis::stream), from 1 to 4095. A target may have
/// two tracks that hand hypotheses to each other: each counts in a half of its own, so that no two
/// hypotheses of a target share random numbers or are taken for each other. A half begins again
/// after its last number. 0 is never given: it stands for no hypothesis.
class HypothesisNumbers {
public:
  /// That of the target as a ball (BernoulliTrack), and as something of any shape (RegionTrack).
  enum class Half : std::uint32_t { Ball, Region };

  explicit HypothesisNumbers(Half half) : half_(half) {}

  void restart() { last_ = 0; }
  std::uint32_t next() {
    last_ = last_ % (kHalf - 1) + 1;
    return static_cast<std::uint32_t>(half_) * kHalf + last_;
  }

private:
  /// Of the 4096 that firstIndex() in track_hypothesis.cpp and RandomKey::streamOfPart() have.
  static constexpr std::uint32_t kHalf = 2048;

  Half half_;
  std::uint32_t last_ = 0; ///< within the half; 0: none was given
};

} // namespace dewpoint::tracking
