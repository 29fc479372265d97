// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"

#include <cmath>
#include <numbers>

namespace dewpoint {
namespace {

// Multipliers and key increments of Philox4x32, table 2 of Salmon et al. 2011.
constexpr std::uint32_t kMultiplier0 = 0xD2511F53;
constexpr std::uint32_t kMultiplier1 = 0xCD9E8D57;
constexpr std::uint32_t kWeyl0 = 0x9E3779B9;
constexpr std::uint32_t kWeyl1 = 0xBB67AE85;
constexpr int kRounds = 10;

constexpr double kTwoPowMinus32 = 1.0 / 4294967296.0;

} // namespace

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < kRounds; ++round) {
    const std::uint64_t product0 = std::uint64_t{kMultiplier0} * counter[0];
    const std::uint64_t product1 = std::uint64_t{kMultiplier1} * counter[2];
    counter = {static_cast<std::uint32_t>(product1 >> 32) ^ counter[1] ^ key[0],
               static_cast<std::uint32_t>(product1),
               static_cast<std::uint32_t>(product0 >> 32) ^ counter[3] ^ key[1],
               static_cast<std::uint32_t>(product0)};
    key = {key[0] + kWeyl0, key[1] + kWeyl1};
  }
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
  std::array<double, 4> normals{};
  for (std::size_t pair = 0; pair < 2; ++pair) {
    // Half a step away from 0, where the logarithm is not finite.
    const double radius = std::sqrt(-2.0 * std::log((word[2 * pair] + 0.5) * kTwoPowMinus32));
    const double angle = 2.0 * std::numbers::pi * (word[2 * pair + 1] * kTwoPowMinus32);
    normals[2 * pair] = radius * std::cos(angle);
    normals[2 * pair + 1] = radius * std::sin(angle);
  }
  return normals;
}

std::uint64_t derivedSeed(std::uint64_t seed, std::uint32_t index) {
  if (index == 0) {
    return seed;
  }
  const auto word = philox({index, 0, 0, 0xDE77}, {static_cast<std::uint32_t>(seed),
                                                   static_cast<std::uint32_t>(seed >> 32)});
  return (std::uint64_t{word[0]} << 32U) | word[1];
}

} // namespace dewpoint
