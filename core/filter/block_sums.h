// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <cstdint>

namespace dewpoint::filter {

/// Number of particles summed together. Their columns fit into the first-level cache.
inline constexpr std::int64_t kSumBlock = 1024;

/// Number of partial sums in strandSum(); element i belongs to partial sum i mod kStrands. The
/// number is fixed, so the loop can be vectorized and every processor rounds in the same way.
constexpr int kStrands = 16;

/// Returns the sum of term(0), ..., term(count - 1), in a fixed order of additions.
template <class Term>
[[gnu::always_inline]] inline double strandSum(std::int64_t count, const Term& term) {
  std::array<double, kStrands> strand{};
  const std::int64_t whole = count - count % kStrands;
  for (std::int64_t i = 0; i < whole; i += kStrands) {
    for (int s = 0; s < kStrands; ++s) {
      strand[std::size_t(s)] += term(i + s);
    }
  }
  for (std::int64_t i = whole; i < count; ++i) {
    strand[std::size_t(i - whole)] += term(i);
  }
  double sum = 0.0;
  for (const double part : strand) {
    sum += part;
  }
  return sum;
}

/// Returns the largest of term(0), ..., term(count - 1), or `least` if none is larger. The inner
/// loop is too long for the compiler to unroll, so it is vectorized.
template <class Term>
[[gnu::always_inline]] inline double strandMax(std::int64_t count, double least, const Term& term) {
  constexpr std::int64_t kMaxStrands = 64;
  std::array<double, kMaxStrands> strands;
  strands.fill(least);
  double* __restrict strand = strands.data();
  const std::int64_t whole = count - count % kMaxStrands;
  for (std::int64_t i = 0; i < whole; i += kMaxStrands) {
    for (std::int64_t s = 0; s < kMaxStrands; ++s) {
      const double value = term(i + s);
      strand[s] = value > strand[s] ? value : strand[s];
    }
  }
  for (std::int64_t s = 0; s < count - whole; ++s) {
    const double value = term(whole + s);
    strand[s] = value > strand[s] ? value : strand[s];
  }
  double most = least;
  for (const double part : strands) {
    most = part > most ? part : most;
  }
  return most;
}

} // namespace dewpoint::filter
