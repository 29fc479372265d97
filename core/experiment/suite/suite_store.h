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

using SuiteResults = std::map<RunKey, SuiteResult>;

/// The files of a suite's folder: runs.csv and traces.csv, and skipped.csv with the runs that could
/// not be made. Results are appended and flushed as they
/// come, so a killed suite loses only what was under way; opening the folder again gives what is
/// there. A last line that was cut is dropped.
class SuiteStore {
public:
  /// Opens or makes the folder. FileUnwritable; Mismatch when its files have other columns (they
  /// are of another version); NotParsed when a line in the middle is broken.
  static Result<SuiteStore> open(const std::filesystem::path& folder);

  /// The results of a folder, which stays as it is. FileMissing when it has no runs.csv; Mismatch
  /// and NotParsed as of open().
  static Result<SuiteResults> read(const std::filesystem::path& folder);

  /// The skipped runs of a folder; none without a skipped.csv. Mismatch and NotParsed as of open().
  static Result<SkippedRuns> readSkipped(const std::filesystem::path& folder);

  const SuiteResults& results() const { return results_; }
  const SkippedRuns& skipped() const { return skipped_; }
  /// Adds results to results() alone; rewrite() writes them. Those of the same run replace others.
  void take(const SuiteResults& results);
  /// The same for skipped().
  void take(const SkippedRuns& skipped);
  /// Appends one result to both files and to results().
  Status append(const SuiteResult& result);
  /// Adds one to skipped.csv and to skipped().
  Status append(const SkippedRun& run);
  /// Writes all files again, in this order of the runs' keys.
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
