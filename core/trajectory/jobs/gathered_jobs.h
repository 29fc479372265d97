// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/evaluation.h"
#include "core/trajectory/jobs/job_record.h"

#include <string>
#include <utility>
#include <vector>

namespace dewpoint::trajectory {

/// A finished job, and its comparison with the ground truth if there was one.
struct GatheredJob {
  std::string folder; ///< path of the output folder, as given by the user
  JobRecord record;
  /// Comparison with the ground truth for each target. The fields `cameraBiases` and `bias` are not
  /// set. Empty if the job was not evaluated.
  std::vector<Evaluation> evaluations;
};

/// Results of many jobs, ordered by job identity. Each job is included once. The order in which the
/// jobs were given or finished has no effect.
struct GatheredJobs {
  std::vector<GatheredJob> jobs;
  std::vector<std::string> missingFolders;    ///< folders that do not exist
  std::vector<std::string> unfinishedFolders; ///< folders whose job did not finish
  /// Pairs of folders that contain the same result of the same job: the folder that is used, and
  /// the folder that is ignored.
  std::vector<std::pair<std::string, std::string>> repeatedFolders;

  bool isComplete() const { return missingFolders.empty() && unfinishedFolders.empty(); }
};

/// Reads the output folders of jobs. Returns Mismatch if two folders contain different results of
/// the same job, or if an evaluation belongs to another trajectory. For an invalid file, returns
/// the errors of readJobRecord().
Result<GatheredJobs> gatherJobs(const std::vector<std::string>& folders);

/// Returns the text of the file that `dewpoint-cli evaluate` writes to an output folder: the
/// numbers, and the checksum of the evaluated trajectory.
std::string evaluationFileText(const std::vector<Evaluation>& evaluations,
                               const std::string& trajectorySha256);

/// Returns a CSV table with one row per job and target. Identical results give identical bytes.
std::string gatheredTableText(const GatheredJobs& gathered);
/// Returns a CSV table with the duration of each job, which differs from run to run.
std::string gatheredDurationsText(const GatheredJobs& gathered);
/// Returns a Markdown page with the results of each method, the worst results, and the missing
/// jobs. Identical results give identical bytes.
std::string gatheredReportText(const GatheredJobs& gathered);

} // namespace dewpoint::trajectory
