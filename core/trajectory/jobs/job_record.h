// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <compare>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::trajectory {

/// The file that a finished job leaves in its output folder, as the last one.
inline constexpr const char* kDoneFile = "done.json";
/// What `dewpoint-cli evaluate` leaves there of the comparison with the truth.
inline constexpr const char* kEvaluationFile = "evaluation.json";

/// A file that a job has written: its name in the output folder, and its content.
struct JobFile {
  std::string name;
  std::uintmax_t bytes = 0;
  std::string sha256;

  bool operator==(const JobFile&) const = default;
};

/// In how many of a job's frames a target had a valid position.
struct JobTarget {
  std::string name;
  std::int64_t validFrames = 0;

  bool operator==(const JobTarget&) const = default;
};

/// What a job is: two of the same identity have to give the same result.
struct JobIdentity {
  std::string recording; ///< as its user calls it
  std::string command;   ///< of dewpoint-cli: track, people
  std::string method;
  std::uint64_t seed = 0;
  std::string settings; ///< what differs from the method's defaults: "particles=200 kld_error=0"
  std::string frames;   ///< which: "0:60"; empty: all
  std::string version;  ///< of the program

  auto operator<=>(const JobIdentity&) const = default;
};

/// A finished job: what done.json says.
struct JobRecord {
  JobIdentity identity;
  std::string key; ///< of all that the result depends on, see jobKey(); empty: it is not repeatable
  std::int64_t frames = 0;
  double seconds = 0.0; ///< wall clock of the tracking
  int threads = 1;
  std::vector<JobTarget> targets;
  std::vector<JobFile> files; ///< which do not change when the job is repeated

  bool operator==(const JobRecord&) const = default;
};

/// A file that a job reads.
struct JobInput {
  std::string name; ///< as the job calls it; no path of one machine
  std::filesystem::path path;
};

/// A checksum of all that a result depends on: of `description` (project, method, parameters, seed,
/// frames) and, of each input, its size and when it was changed; of a folder, those of all its
/// files. Small inputs (up to 1 MB) are compared by content instead. FileMissing, FileUnreadable.
Result<std::string> jobKey(const std::string& description, const std::vector<JobInput>& inputs);

std::string jobRecordText(const JobRecord& record);
/// NotParsed with the file's name where it is none of ours.
Result<JobRecord> readJobRecord(const std::filesystem::path& file);

} // namespace dewpoint::trajectory
