// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/suite/suite_summary.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace dewpoint::tests {

/// A run that nobody has made: one target that is followed with these errors, millimeters, and no
/// figures but those that a test sets.
inline SuiteResult resultOf(const std::string& scenario, Grade grade, const std::string& method,
                            std::uint64_t seed = 1,
                            const std::vector<double>& errorsMm = {1.0, 1.0, 1.0, 1.0, 1.0}) {
  SuiteResult result;
  result.row.key = result.trace.key = {scenario, grade, method, seed};
  result.row.framesToConverge = 0.0;
  result.row.frameCount = static_cast<double>(errorsMm.size());
  result.trace.errorsMm = {errorsMm};
  result.trace.reliabilityCounts.resize(kReliabilityBins);
  return result;
}

/// Some results, by their keys, and the order in which they were given.
struct MadeResults {
  SuiteResults results;
  std::vector<RunKey> order;

  void add(const SuiteResult& result) {
    results.insert_or_assign(result.row.key, result);
    order.push_back(result.row.key);
  }
  std::vector<SuiteCell> cells() const { return summarizeSuite(results, order); }
};

/// What stands in a file of the suite.
inline std::string contents(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

} // namespace dewpoint::tests
