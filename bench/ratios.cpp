// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/ratios.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

namespace dewpoint::bench {
namespace {

struct Times {
  double cpuNs = 0.0;
  double wallNs = 0.0;
};

/// Prints as usual, and keeps the fastest repetition of every benchmark.
class FastestReporter : public benchmark::ConsoleReporter {
public:
  FastestReporter() : ConsoleReporter(OO_Tabular) {}

  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) {
        continue;
      }
      const double perNs = 1e9 / double(run.iterations);
      const Times times{run.cpu_accumulated_time * perNs, run.real_accumulated_time * perNs};
      std::string name = run.benchmark_name();
      name = name.substr(0, name.find("/repeats:"));
      const auto [entry, isNew] = fastest_.emplace(name, times);
      if (!isNew) {
        entry->second.cpuNs = std::min(entry->second.cpuNs, times.cpuNs);
        entry->second.wallNs = std::min(entry->second.wallNs, times.wallNs);
      }
    }
  }

  std::optional<Times> fastest(const std::string& name) const {
    const auto found = fastest_.find(name);
    return found == fastest_.end() ? std::nullopt : std::optional(found->second);
  }

private:
  std::map<std::string, Times> fastest_;
};

std::string assessment(double bar, bool reached, std::string_view relation) {
  return bar > 0.0 ? fmt::format("   {} {:g}: {}", relation, bar, reached ? "reached" : "MISSED")
                   : std::string();
}

void print(const Cost& cost, const FastestReporter& reporter) {
  if (const auto times = reporter.fastest(cost.name)) {
    const double ns = times->cpuNs / cost.elements;
    fmt::print("{:<58} {:9.3f} ns{}\n", cost.title, ns,
               assessment(cost.barNs, ns <= cost.barNs, "<="));
  }
}

void print(const Ratio& ratio, const FastestReporter& reporter) {
  const auto slow = reporter.fastest(ratio.slow);
  const auto fast = reporter.fastest(ratio.fast);
  if (slow && fast) {
    const auto pick = [&](const Times& times) {
      return ratio.wallClock ? times.wallNs : times.cpuNs;
    };
    const double value = (pick(*slow) / ratio.slowElements) / (pick(*fast) / ratio.fastElements);
    fmt::print("{:<58} {:9.2f} x {}\n", ratio.title, value,
               assessment(ratio.bar, value >= ratio.bar, ">="));
  }
}

} // namespace

int runBenchmarks(int argc, char** argv, const std::vector<Cost>& costs,
                  const std::vector<Ratio>& ratios) {
  // What the user says comes later, so it wins.
  std::string repetitions = "--benchmark_repetitions=3";
  std::string quiet = "--benchmark_report_aggregates_only=false";
  std::vector<char*> arguments(argv, argv + argc);
  arguments.insert(arguments.begin() + 1, {repetitions.data(), quiet.data()});
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) {
    return 2;
  }
  FastestReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  fmt::print("\n");
  for (const Cost& cost : costs) {
    print(cost, reporter);
  }
  for (const Ratio& ratio : ratios) {
    print(ratio, reporter);
  }
  return 0;
}

} // namespace dewpoint::bench
