// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <cstdint>

namespace dewpoint::filter {

/// Number of particles in a block. A block is processed as a whole; its columns fit into the
/// first-level cache.
inline constexpr std::int64_t kSumBlock = 1024;

/// Number of partial sums in sumInLanes(); element i belongs to partial sum i mod kSumLanes. The
/// number is fixed, so the loop can be vectorized and every processor rounds in the same way.
constexpr int kSumLanes = 16;

/// Returns the sum of term(0), ..., term(count - 1), in a fixed order of additions.
template <class Term>
[[gnu::always_inline]] inline double sumInLanes(std::int64_t count, const Term& term) {
  std::array<double, kSumLanes> lane{};
  const std::int64_t whole = count - count % kSumLanes;
  for (std::int64_t i = 0; i < whole; i += kSumLanes) {
    for (int s = 0; s < kSumLanes; ++s) {
      lane[std::size_t(s)] += term(i + s);
    }
  }
  for (std::int64_t i = whole; i < count; ++i) {
    lane[std::size_t(i - whole)] += term(i);
  }
  double sum = 0.0;
  for (const double part : lane) {
    sum += part;
  }
  return sum;
}

/// Returns the largest of term(0), ..., term(count - 1), or `least` if none is larger. The inner
/// loop is too long for the compiler to unroll, so it is vectorized.
template <class Term>
[[gnu::always_inline]] inline double maxInLanes(std::int64_t count, double least,
                                                const Term& term) {
  constexpr std::int64_t kLanesOfMax = 64;
  std::array<double, kLanesOfMax> lanes;
  lanes.fill(least);
  double* __restrict lane = lanes.data();
  const std::int64_t whole = count - count % kLanesOfMax;
  for (std::int64_t i = 0; i < whole; i += kLanesOfMax) {
    for (std::int64_t s = 0; s < kLanesOfMax; ++s) {
      const double value = term(i + s);
      lane[s] = value > lane[s] ? value : lane[s];
    }
  }
  for (std::int64_t s = 0; s < count - whole; ++s) {
    const double value = term(whole + s);
    lane[s] = value > lane[s] ? value : lane[s];
  }
  double most = least;
  for (const double part : lanes) {
    most = part > most ? part : most;
  }
  return most;
}

} // namespace dewpoint::filter
