// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <cstdint>

namespace dewpoint::base {

/// Returns four random words as a pure function of counter and key; see Philox.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key);

/// Purpose for which random numbers are drawn. Each purpose has its own stream, so numbers for
/// different purposes are independent.
enum class RandomPurpose : std::uint32_t {
  Start,  ///< initial states of particles
  Motion, ///< noise of the motion model
  Resampling,
  Simulation, ///< simulated images and observations
  Noise,      ///< tables of random numbers for simulated image noise
  Resize,     ///< changes of the number of particles
  Proposal,   ///< proposal distribution of a particle filter
  Search      ///< search for a target whose position is unknown
};

/// Random numbers for one filter iteration. Element i of a stream is a pure function of (seed,
/// frame, iteration, purpose, i).
class RandomStream {
public:
  RandomStream(std::uint64_t seed, std::uint32_t frame, std::uint32_t iteration,
               RandomPurpose purpose);

  /// Returns four uniformly distributed 32-bit words for element `index`. Each value of `block`
  /// yields four different words for the same element.
  std::array<std::uint32_t, 4> randomWords(std::uint32_t index, std::uint32_t block = 0) const;
  /// Returns a uniform number in [0, 1) with 53 random bits, computed from randomWords(index,
  /// block).
  double uniform(std::uint32_t index, std::uint32_t block = 0) const;
  /// Returns three uniform numbers in [0, 1) with 32 random bits each, computed from
  /// randomWords(index, block).
  std::array<double, 3> uniform3(std::uint32_t index, std::uint32_t block = 0) const;
  /// Returns four independent standard normal numbers, computed from randomWords(index, block) by
  /// the Box-Muller method (box_muller.h).
  std::array<double, 4> normal4(std::uint32_t index, std::uint32_t block = 0) const;

  /// Returns three independent standard normal numbers, computed in single precision: the first
  /// three of normal4().
  std::array<float, 3> normal3(std::uint32_t index) const;

  /// Returns four independent exponentially distributed numbers with mean 1, in single precision.
  std::array<float, 4> exponential4(std::uint32_t index) const;

  /// Writes three standard normal numbers, normal3(i), for each of `count` elements i into three
  /// columns. The first element is `firstIndex`. The columns must not overlap.
  void fillNormal3(std::uint32_t firstIndex, std::int64_t count,
                   const std::array<double*, 3>& columns) const;
  /// Writes four standard normal numbers, normal4(i, block), for each of `count` elements i into
  /// four columns. The first element is `firstIndex`. The columns must not overlap.
  void fillNormal4(std::uint32_t firstIndex, std::uint32_t block, std::int64_t count,
                   const std::array<double*, 4>& columns) const;
  /// Writes four exponentially distributed numbers, exponential4(i), for each of `count` elements i
  /// into four columns. The first element is `firstIndex`. The columns must not overlap.
  void fillExponential4(std::uint32_t firstIndex, std::int64_t count,
                        const std::array<float*, 4>& columns) const;

private:
  friend struct RandomBatch;

  std::array<std::uint32_t, 2> key_;
  std::uint32_t frame_;
  std::uint32_t iteration_;
  std::uint32_t purpose_;
};

/// Returns the seed for part `index` of a computation whose seed is `seed`. The seed for part 0 is
/// `seed` itself.
std::uint64_t derivedSeed(std::uint64_t seed, std::uint32_t index);

} // namespace dewpoint::base
