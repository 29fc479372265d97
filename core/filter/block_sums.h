// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <cstdint>

namespace dewpoint::filter {

/// Particles that are summed up together: their columns fit into the first-level cache.
inline constexpr std::int64_t kSumBlock = 1024;

/// A sum over elements 0, 1, ..., taken in a fixed number of strands (element i belongs to strand i
/// mod kStrands), so that vector units can take it and every processor rounds it alike.
constexpr int kStrands = 16;

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

/// The largest of elements 0, 1, ..., or `least` if none is larger. The inner loop is too long for
/// the compiler to unroll it, and so becomes vector code.
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
