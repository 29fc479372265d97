// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numbers>

/// Elementary functions built from additions and multiplications in a fixed order, without
/// branches. Loops that call these functions compile to vector code. The functions produce the same
/// bits on every processor and with every library, which std::log, std::sin and std::exp do not
/// guarantee. Errors are a few units in the last place.
namespace dewpoint::base {

/// Evaluates the polynomial c[0] + c[1] x + c[2] x^2 + ...
template <std::size_t Count>
[[gnu::always_inline]] inline double polynomial(double x, const std::array<double, Count>& c) {
  double sum = c[Count - 1];
  for (std::size_t i = Count - 1; i-- > 0;) {
    sum = sum * x + c[i];
  }
  return sum;
}

/// Returns the natural logarithm of x, which must be a positive normal number (not subnormal,
/// infinite or NaN). Method: x = 2^k m with m between sqrt(1/2) and sqrt(2), and the series of log
/// m = 2 artanh((m - 1) / (m + 1)). The omitted terms of the series are below 1e-17.
[[gnu::always_inline]] inline double logarithm(double x) {
  constexpr std::array<double, 11> kArtanh{1.0,        1.0 / 3.0,  1.0 / 5.0,  1.0 / 7.0,
                                           1.0 / 9.0,  1.0 / 11.0, 1.0 / 13.0, 1.0 / 15.0,
                                           1.0 / 17.0, 1.0 / 19.0, 1.0 / 21.0};
  constexpr auto kRootHalf = std::bit_cast<std::uint64_t>(std::numbers::sqrt2 / 2.0);
  constexpr std::uint64_t kBias = 1023;
  constexpr std::uint64_t kTwoTo52 =
      0x4330000000000000; // an integer in its low bits is added to 2^52
  const auto bits = std::bit_cast<std::uint64_t>(x);
  // Biased to keep it nonnegative: vector units cannot shift signed 64-bit numbers.
  const std::uint64_t exponent = (bits - kRootHalf + (kBias << 52U)) >> 52U;
  const double k = std::bit_cast<double>(kTwoTo52 | exponent) - (0x1.0p52 + double(kBias));
  const double m = std::bit_cast<double>(bits - ((exponent - kBias) << 52U));
  const double s = (m - 1.0) / (m + 1.0);
  return k * std::numbers::ln2 + 2.0 * s * polynomial(s * s, kArtanh);
}

/// Cosine and sine of an angle.
struct CosineSine {
  double cosine;
  double sine;
};

/// Returns the cosine and sine of an angle of `turn` / 2^32 full turns. Method: the nearest
/// multiple of a quarter turn is subtracted exactly, using integers. A Taylor series is then
/// evaluated for the remainder, which is at most an eighth of a turn. The omitted terms of the
/// series are below 1e-16.
[[gnu::always_inline]] inline CosineSine cosineSine(std::uint32_t turn) {
  constexpr std::array<double, 9> kSine{1.0,
                                        -1.0 / 6.0,
                                        1.0 / 120.0,
                                        -1.0 / 5040.0,
                                        1.0 / 362880.0,
                                        -1.0 / 39916800.0,
                                        1.0 / 6227020800.0,
                                        -1.0 / 1307674368000.0,
                                        1.0 / 355687428096000.0};
  constexpr std::array<double, 9> kCosine{1.0,
                                          -1.0 / 2.0,
                                          1.0 / 24.0,
                                          -1.0 / 720.0,
                                          1.0 / 40320.0,
                                          -1.0 / 3628800.0,
                                          1.0 / 479001600.0,
                                          -1.0 / 87178291200.0,
                                          1.0 / 20922789888000.0};
  const std::uint32_t quarter = (turn + (1U << 29U)) >> 30U; // 0 to 4, where 4 is equivalent to 0
  const auto rest = static_cast<std::int32_t>(turn - (quarter << 30U));
  const double angle = rest * (0x1.0p-31 * std::numbers::pi);
  const double square = angle * angle;
  const double sine = angle * polynomial(square, kSine);
  const double cosine = polynomial(square, kCosine);
  const bool swapped = (quarter & 1U) != 0;
  const double first = swapped ? sine : cosine;
  const double second = swapped ? cosine : sine;
  const double cosineSign = ((quarter + 1U) & 2U) != 0 ? -1.0 : 1.0;
  const double sineSign = (quarter & 2U) != 0 ? -1.0 : 1.0;
  return {cosineSign * first, sineSign * second};
}

/// Returns e^x for x <= 0. Returns 0 for x below -700, including minus infinity, and for NaN.
/// Method: x = k ln 2 + r with |r| <= ln 2 / 2, and the Taylor series for e^r. The omitted terms of
/// the series are below 1e-17.
[[gnu::always_inline]] inline double exponential(double x) {
  constexpr std::array<double, 14> kExp{1.0,
                                        1.0,
                                        1.0 / 2.0,
                                        1.0 / 6.0,
                                        1.0 / 24.0,
                                        1.0 / 120.0,
                                        1.0 / 720.0,
                                        1.0 / 5040.0,
                                        1.0 / 40320.0,
                                        1.0 / 362880.0,
                                        1.0 / 3628800.0,
                                        1.0 / 39916800.0,
                                        1.0 / 479001600.0,
                                        1.0 / 6227020800.0};
  constexpr double kLn2High =
      0x1.62e42fee00000p-1; // ends in zeros, so its products with k are exact
  constexpr double kLn2Low = 0x1.a39ef35793c76p-33;
  constexpr double kRounding = 0x1.8p52; // doubles of this size have no fractional bits
  const bool normal = x >= -700.0;
  const double safe = normal ? x : 0.0;
  const double shifted = safe * std::numbers::log2e + kRounding;
  const double k = shifted - kRounding;
  const double r = (safe - k * kLn2High) - k * kLn2Low;
  const auto exponent = std::bit_cast<std::uint64_t>(shifted) + 1023U; // its low bits are k
  const double power = std::bit_cast<double>(exponent << 52U);
  return normal ? power * polynomial(r, kExp) : 0.0;
}

} // namespace dewpoint::base
