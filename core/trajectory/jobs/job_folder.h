// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/jobs/job_record.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::trajectory {

/// Lies in an output folder while its job runs, and stays there when the job is killed.
inline constexpr const char* kUnfinishedFile = "unfinished";

/// The output folder of a job. From begin() to finish() it holds a file `unfinished`; done.json is
/// written as the last file, so that a job that was killed is never taken for one that is done.
class JobFolder {
public:
  /// What the folder says of a finished job with this key, whose files are all there with their
  /// sizes; nothing otherwise, and for an empty key.
  static std::optional<JobRecord> finished(const std::filesystem::path& folder,
                                           const std::string& key);

  /// Makes the folder and takes away what a former job has left there, done.json first, and the
  /// files of these names, which this job will write; other files stay. FileUnwritable.
  static Result<JobFolder> begin(const std::filesystem::path& folder,
                                 const std::vector<std::string>& names);

  /// Says that the job is done, and that it wrote the files of these names. Their sizes and
  /// checksums go into the record. FileUnwritable also where another process has begun a job in
  /// the same folder since: the folder is that one's.
  Status finish(JobRecord record, const std::vector<std::string>& names) const;

private:
  JobFolder(std::filesystem::path folder, std::string token)
      : folder_(std::move(folder)), token_(std::move(token)) {}

  std::filesystem::path folder_;
  std::string token_; ///< the content of `unfinished`, different for each job
};

} // namespace dewpoint::trajectory
