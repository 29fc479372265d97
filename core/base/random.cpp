// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"

#include "core/base/box_muller.h"
#include "core/base/philox.h"

namespace dewpoint::base {
namespace {

constexpr double kTwoPowMinus32 = 1.0 / 4294967296.0;

} // namespace

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key) {
  auto& [c0, c1, c2, c3] = counter;
  Philox::mix(c0, c1, c2, c3, key[0], key[1]);
  return counter;
}

RandomStream::RandomStream(std::uint64_t seed, std::uint32_t frame, std::uint32_t iteration,
                           RandomPurpose purpose)
    : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}, frame_(frame),
      iteration_(iteration), purpose_(static_cast<std::uint32_t>(purpose)) {}

std::array<std::uint32_t, 4> RandomStream::words(std::uint32_t index, std::uint32_t block) const {
  return philox({index, iteration_, frame_, (purpose_ << 24U) | block}, key_);
}

double RandomStream::uniform(std::uint32_t index, std::uint32_t block) const {
  const auto word = words(index, block);
  const std::uint64_t bits = (std::uint64_t{word[0]} << 21U) ^ (word[1] >> 11U);
  return static_cast<double>(bits) * 0x1.0p-53;
}

std::array<double, 3> RandomStream::uniform3(std::uint32_t index, std::uint32_t block) const {
  const auto word = words(index, block);
  return {word[0] * kTwoPowMinus32, word[1] * kTwoPowMinus32, word[2] * kTwoPowMinus32};
}

std::array<double, 4> RandomStream::normal4(std::uint32_t index, std::uint32_t block) const {
  const auto word = words(index, block);
  const auto [first, second] = boxMuller(word[0], word[1]);
  const auto [third, fourth] = boxMuller(word[2], word[3]);
  return {first, second, third, fourth};
}

std::array<float, 3> RandomStream::normal3(std::uint32_t index) const {
  const auto word = words(index);
  const auto [first, second] = boxMullerSingle(word[0], word[1]);
  return {first, second, boxMullerSingle(word[2], word[3]).first};
}

std::array<float, 4> RandomStream::exponential4(std::uint32_t index) const {
  const auto word = words(index);
  return {exponentialVariate(word[0]), exponentialVariate(word[1]), exponentialVariate(word[2]),
          exponentialVariate(word[3])};
}

std::uint64_t derivedSeed(std::uint64_t seed, std::uint32_t index) {
  if (index == 0) {
    return seed;
  }
  const auto word = philox({index, 0, 0, 0xDE77}, {static_cast<std::uint32_t>(seed),
                                                   static_cast<std::uint32_t>(seed >> 32)});
  return (std::uint64_t{word[0]} << 32U) | word[1];
}

} // namespace dewpoint::base
