// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/elementary.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numbers>

/// The functions of elementary.h in single precision, for generating millions of random numbers.
/// Numbers have half the size, and the series have half the terms. Vector units therefore process
/// four times as many numbers per second. Errors are a few units in the last place, and every
/// processor produces the same bits.
namespace dewpoint::base {

/// Evaluates the polynomial c[0] + c[1] x + c[2] x^2 + ...
template <std::size_t Count>
[[gnu::always_inline]] inline float polynomial(float x, const std::array<float, Count>& c) {
  float sum = c[Count - 1];
  for (std::size_t i = Count - 1; i-- > 0;) {
    sum = sum * x + c[i];
  }
  return sum;
}

/// Returns the natural logarithm of x, which must be a positive normal number. This is the
/// single-precision version of logarithm(double) in elementary.h.
[[gnu::always_inline]] inline float logarithm(float x) {
  constexpr std::array<float, 5> kArtanh{1.0F, 1.0F / 3.0F, 1.0F / 5.0F, 1.0F / 7.0F, 1.0F / 9.0F};
  constexpr auto kRootHalf = std::bit_cast<std::uint32_t>(std::numbers::sqrt2_v<float> / 2.0F);
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::int32_t exponent = static_cast<std::int32_t>(bits - kRootHalf) >> 23U;
  const auto m = std::bit_cast<float>(bits - (static_cast<std::uint32_t>(exponent) << 23U));
  const float s = (m - 1.0F) / (m + 1.0F);
  return static_cast<float>(exponent) * std::numbers::ln2_v<float> +
         2.0F * s * polynomial(s * s, kArtanh);
}

/// Cosine and sine of an angle, in single precision.
struct CosineSineSingle {
  float cosine;
  float sine;
};

/// Returns the cosine and sine of an angle of `turn` / 2^32 full turns. This is the
/// single-precision version of cosineSine() in elementary.h.
[[gnu::always_inline]] inline CosineSineSingle cosineSineSingle(std::uint32_t turn) {
  constexpr std::array<float, 5> kSine{1.0F, -1.0F / 6.0F, 1.0F / 120.0F, -1.0F / 5040.0F,
                                       1.0F / 362880.0F};
  constexpr std::array<float, 5> kCosine{1.0F, -1.0F / 2.0F, 1.0F / 24.0F, -1.0F / 720.0F,
                                         1.0F / 40320.0F};
  constexpr float kAnglePerTurn = 0x1.0p-31F * std::numbers::pi_v<float>;
  const std::uint32_t quarter = (turn + (1U << 29U)) >> 30U; // 0 to 4, where 4 is equivalent to 0
  const float angle =
      static_cast<float>(static_cast<std::int32_t>(turn - (quarter << 30U))) * kAnglePerTurn;
  const float square = angle * angle;
  const float sine = angle * polynomial(square, kSine);
  const float cosine = polynomial(square, kCosine);
  const bool swapped = (quarter & 1U) != 0;
  const auto first = std::bit_cast<std::uint32_t>(swapped ? sine : cosine);
  const auto second = std::bit_cast<std::uint32_t>(swapped ? cosine : sine);
  const std::uint32_t cosineSign = ((quarter + 1U) & 2U) << 30U;
  const std::uint32_t sineSign = (quarter & 2U) << 30U;
  return {std::bit_cast<float>(first ^ cosineSign), std::bit_cast<float>(second ^ sineSign)};
}

/// Returns (word + 1/2) / 2^32, rounded. The result is above 0 and at most 1. The two halves of the
/// word are converted separately, because all vector units can convert such small integers to
/// floating point.
[[gnu::always_inline]] inline float toUnitInterval(std::uint32_t word) {
  const auto high = static_cast<float>(static_cast<std::int32_t>(word >> 16U));
  const auto low = static_cast<float>(static_cast<std::int32_t>(word & 0xFFFFU));
  return high * 0x1.0p-16F + (low + 0.5F) * 0x1.0p-32F;
}

} // namespace dewpoint::base
