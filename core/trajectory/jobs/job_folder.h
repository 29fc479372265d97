// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/jobs/job_record.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::trajectory {

/// File that marks the output folder of an unfinished job. It exists while the job runs, and
/// remains if the job is killed.
inline constexpr const char* kUnfinishedFile = "unfinished";

/// Output folder of a job. It holds a file `unfinished` from beginJob() to finish(). The file
/// done.json is written last, so a killed job is never mistaken for a finished one.
class JobFolder {
public:
  /// Returns the record of a finished job whose key (a checksum of everything that its result
  /// depends on) is `key`, if all its files exist with their recorded sizes. Otherwise, and for an
  /// empty key, returns nothing.
  static std::optional<JobRecord> readFinishedRecord(const std::filesystem::path& folder,
                                                     const std::string& key);

  /// Creates the folder and begins a job in it. Files of an earlier job are removed, done.json
  /// first. Files with these `names`, which the new job will write, are also removed. Other files
  /// are kept. Returns FileUnwritable if this fails.
  static Result<JobFolder> beginJob(const std::filesystem::path& folder,
                                    const std::vector<std::string>& names);

  /// Marks the job as finished. The files with these `names` are recorded with their sizes and
  /// checksums. Returns FileUnwritable if this fails. Also returns FileUnwritable, and leaves the
  /// folder unchanged, if another process has begun a job in the same folder since beginJob().
  Status finish(JobRecord record, const std::vector<std::string>& names) const;

private:
  JobFolder(std::filesystem::path folder, std::string token)
      : folder_(std::move(folder)), token_(std::move(token)) {}

  std::filesystem::path folder_;
  std::string token_; ///< content of `unfinished`, different for each job
};

} // namespace dewpoint::trajectory
