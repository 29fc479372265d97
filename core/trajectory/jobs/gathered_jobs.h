// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/evaluation.h"
#include "core/trajectory/jobs/job_record.h"

#include <string>
#include <utility>
#include <vector>

namespace dewpoint::trajectory {

/// A finished job and what its comparison with the truth said, if there was one.
struct GatheredJob {
  std::string folder; ///< as it was given
  JobRecord record;
  std::vector<Evaluation> evaluations; ///< without cameras and bias; empty: not evaluated
};

/// The results of many jobs, each once, in the order of their identities, whatever order they were
/// given in or finished in.
struct GatheredJobs {
  std::vector<GatheredJob> jobs;
  std::vector<std::string> missing;    ///< folders that are not there
  std::vector<std::string> unfinished; ///< folders whose job did not come to its end
  /// Folders with the same result: the one that counts, and the other.
  std::vector<std::pair<std::string, std::string>> repeated;

  bool isComplete() const { return missing.empty() && unfinished.empty(); }
};

/// Reads the output folders of jobs. Mismatch where two folders have different results of the same
/// job, or an evaluation is of another trajectory; NotParsed.
Result<GatheredJobs> gatherJobs(const std::vector<std::string>& folders);

/// What `dewpoint-cli evaluate` leaves in an output folder: the numbers, and the checksum of the
/// trajectory that they are of.
std::string evaluationFileText(const std::vector<Evaluation>& evaluations,
                               const std::string& trajectorySha256);

/// One row per job and target, CSV. The same bytes for the same results.
std::string gatheredTable(const GatheredJobs& gathered);
/// How long each job took, CSV; this differs from run to run.
std::string gatheredTimes(const GatheredJobs& gathered);
/// A page about them, Markdown: each method's results, the worst ones, what is missing. The same
/// bytes for the same results.
std::string gatheredReport(const GatheredJobs& gathered);

} // namespace dewpoint::trajectory
