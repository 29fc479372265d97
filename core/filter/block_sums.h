// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace dewpoint {

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

/// The largest of elements 0, 1, ..., or `least` if none is larger.
template <class Term>
[[gnu::always_inline]] inline double strandMax(std::int64_t count, double least, const Term& term) {
  std::array<double, kStrands> strand;
  strand.fill(least);
  const auto take = [&](std::int64_t i, std::size_t s) __attribute__((always_inline)) {
    const double value = term(i);
    strand[s] = value > strand[s] ? value : strand[s];
  };
  const std::int64_t whole = count - count % kStrands;
  for (std::int64_t i = 0; i < whole; i += kStrands) {
    for (int s = 0; s < kStrands; ++s) {
      take(i + s, std::size_t(s));
    }
  }
  for (std::int64_t i = whole; i < count; ++i) {
    take(i, std::size_t(i - whole));
  }
  double most = least;
  for (const double part : strand) {
    most = part > most ? part : most;
  }
  return most;
}

} // namespace dewpoint
