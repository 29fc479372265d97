// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <cstdint>

namespace dewpoint::base {

/// Returns four random words as a pure function of counter and key; see Philox.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key);

/// Purpose of random numbers. Each purpose has its own stream.
enum class RandomPurpose : std::uint32_t {
  Start,
  Motion,
  Resampling,
  Simulation,
  Noise,
  Resize,
  Proposal,
  Search
};

/// Random numbers for one filter iteration. Element i of a stream is a pure function of (seed,
/// frame, iteration, purpose, i).
class RandomStream {
public:
  RandomStream(std::uint64_t seed, std::uint32_t frame, std::uint32_t iteration,
               RandomPurpose purpose);

  /// Returns four uniform words for element `index`. Other values of `block` yield additional words
  /// for the same element.
  std::array<std::uint32_t, 4> words(std::uint32_t index, std::uint32_t block = 0) const;
  /// Returns a uniform number in [0, 1) with 53 random bits, computed from words(index, block).
  double uniform(std::uint32_t index, std::uint32_t block = 0) const;
  /// Returns three uniform numbers in [0, 1) with 32 random bits each, computed from words(index,
  /// block).
  std::array<double, 3> uniform3(std::uint32_t index, std::uint32_t block = 0) const;
  /// Returns four independent standard normal numbers (Box-Muller, with the functions of
  /// elementary.h).
  std::array<double, 4> normal4(std::uint32_t index, std::uint32_t block = 0) const;

  /// Returns the first three numbers of normal4(), computed in single precision.
  std::array<float, 3> normal3(std::uint32_t index) const;

  /// Returns four independent exponentially distributed numbers with mean 1, in single precision.
  std::array<float, 4> exponential4(std::uint32_t index) const;

  /// Writes normal3(i) for `count` elements i, starting with `firstIndex`, into three columns. The
  /// columns must not overlap.
  void fillNormal3(std::uint32_t firstIndex, std::int64_t count,
                   const std::array<double*, 3>& columns) const;
  /// Writes normal4(i, block) for `count` elements i, starting with `firstIndex`, into four
  /// columns. The columns must not overlap.
  void fillNormal4(std::uint32_t firstIndex, std::uint32_t block, std::int64_t count,
                   const std::array<double*, 4>& columns) const;
  /// Writes exponential4(i) for `count` elements i, starting with `firstIndex`, into four columns.
  /// The columns must not overlap.
  void fillExponential4(std::uint32_t firstIndex, std::int64_t count,
                        const std::array<float*, 4>& columns) const;

private:
  friend struct RandomBatch;

  std::array<std::uint32_t, 2> key_;
  std::uint32_t frame_;
  std::uint32_t iteration_;
  std::uint32_t purpose_;
};

/// Derives a seed for part `index` of a computation with seed `seed`. Part 0 uses `seed` unchanged.
std::uint64_t derivedSeed(std::uint64_t seed, std::uint32_t index);

} // namespace dewpoint::base
