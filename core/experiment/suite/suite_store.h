// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/suite/skipped_runs.h"
#include "core/experiment/suite/suite_recorder.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <vector>

namespace dewpoint::experiment {

/// Results of the suite, indexed by run key.
using SuiteResults = std::map<RunKey, SuiteResult>;

/// Stores the results of a suite in the files of a folder: runs.csv, traces.csv, and skipped.csv
/// with the runs that could not be created. The result of each run is written as soon as the run
/// has finished, so an interrupted suite loses only unfinished runs. Opening the folder again
/// restores the results; an incomplete last line is dropped.
class SuiteStore {
public:
  /// Opens or creates the folder. Returns FileUnwritable if this fails, Mismatch if its files have
  /// different columns (from another version), and NotParsed if any line except the last is broken.
  static Result<SuiteStore> open(const std::filesystem::path& folder);

  /// Reads the results in a folder without changing the folder. Returns FileMissing if there is no
  /// runs.csv. Returns Mismatch and NotParsed as open() does.
  static Result<SuiteResults> read(const std::filesystem::path& folder);

  /// Reads the skipped runs of a folder. The result is empty if there is no skipped.csv. Returns
  /// Mismatch and NotParsed as open() does.
  static Result<SkippedRuns> readSkipped(const std::filesystem::path& folder);

  const SuiteResults& results() const { return results_; }
  const SkippedRuns& skippedRuns() const { return skipped_; }
  /// Adds results to results(), and replaces existing results of the same runs. The files do not
  /// change until rewrite() is called.
  void merge(const SuiteResults& results);
  /// Adds skipped runs to skippedRuns(). The files do not change until rewrite() is called.
  void merge(const SkippedRuns& skipped);
  /// Adds one result to runs.csv, to traces.csv and to results().
  Status append(const SuiteResult& result);
  /// Adds one skipped run to skipped.csv and to skippedRuns().
  Status append(const SkippedRun& run);
  /// Rewrites all files, with the runs in the order of the given keys.
  Status rewrite(const std::vector<RunKey>& order);

private:
  explicit SuiteStore(std::filesystem::path folder) : folder_(std::move(folder)) {}
  Status load();
  Status openForAppending();
  Status writeSkipped() const;

  std::filesystem::path folder_;
  SuiteResults results_;
  SkippedRuns skipped_;
  std::ofstream runs_;
  std::ofstream traces_;
};

} // namespace dewpoint::experiment
