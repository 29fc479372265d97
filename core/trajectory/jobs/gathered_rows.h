// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/jobs/gathered_jobs.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::trajectory {

/// Result of one target in one job.
struct GatheredRow {
  const GatheredJob* job = nullptr;
  std::string target; ///< name of the target; empty: the job found no target
  std::int64_t validFrameCount = 0;
  const Evaluation* evaluation = nullptr; ///< comparison with the truth; null if there is no truth

  /// Returns the fraction of the job's frames in which the target had a valid position; 0 without
  /// frames.
  double validFraction() const {
    return job->record.frameCount > 0
               ? static_cast<double>(validFrameCount) / static_cast<double>(job->record.frameCount)
               : 0.0;
  }
};

/// Returns the rows of all jobs; the targets of a job are ordered by name. The result points into
/// `gathered`.
std::vector<GatheredRow> gatheredRowsOf(const GatheredJobs& gathered);

} // namespace dewpoint::trajectory
