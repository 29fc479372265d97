// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

namespace dewpoint::bench {

/// What a benchmark program compares: "slow" takes so many times as long as "fast".
struct Ratio {
  std::string title;
  std::string slow; ///< benchmark names as Google Benchmark prints them
  std::string fast;
  double bar = 0.0; ///< the ratio to reach; 0 for none
  /// Times are divided by this many elements each; 1 compares the benchmarks as they are.
  double slowElements = 1.0;
  double fastElements = 1.0;
  bool wallClock = false; ///< else CPU time of the calling thread
};

/// A time to report by itself, in nanoseconds for each of `elements`.
struct Cost {
  std::string title;
  std::string name;
  double elements = 1.0;
  double barNs = 0.0; ///< at most; 0 for none
};

/// Runs the registered benchmarks (as often as --benchmark_repetitions says, three times by
/// default) and prints the costs and ratios of their fastest repetitions beneath. Returns the exit
/// code of the program: 0 also where a bar is missed, which is printed.
int runBenchmarks(int argc, char** argv, const std::vector<Cost>& costs,
                  const std::vector<Ratio>& ratios);

} // namespace dewpoint::bench
