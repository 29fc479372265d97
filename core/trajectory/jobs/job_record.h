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

/// Name of the file that a finished job writes last to its output folder.
inline constexpr const char* kDoneFile = "done.json";
/// Name of the file in which `dewpoint-cli evaluate` stores the comparison with the truth.
inline constexpr const char* kEvaluationFile = "evaluation.json";

/// A file that a job has written: its name in the output folder, its size and its checksum.
struct JobFile {
  std::string name;
  std::uintmax_t byteCount = 0;
  std::string sha256;

  bool operator==(const JobFile&) const = default;
};

/// Number of a job's frames in which a target had a valid position.
struct JobTarget {
  std::string name;
  std::int64_t validFrameCount = 0;

  bool operator==(const JobTarget&) const = default;
};

/// Identity of a job: two jobs with the same identity must give the same result.
struct JobIdentity {
  std::string recordingName; ///< name that the user gave to the recording
  std::string command;       ///< command of dewpoint-cli: "track" or "people"
  std::string method;
  std::uint64_t seed = 0;
  /// Parameters that differ from the method's defaults, for example "particles=200 kld_error=0".
  std::string nonDefaultSettings;
  std::string frameRange; ///< range of frames, for example "0:60"; empty: all frames
  std::string version;    ///< version of Dewpoint

  auto operator<=>(const JobIdentity&) const = default; // NOLINT(modernize-use-nullptr)
};

/// Record of a finished job, stored in done.json.
struct JobRecord {
  JobIdentity identity;
  /// Checksum of everything that the result depends on; see jobKey(). Empty if the job is not
  /// repeatable.
  std::string key;
  std::int64_t frameCount = 0;
  double trackingSeconds = 0.0; ///< wall-clock time for tracking
  int threadCount = 1;
  std::vector<JobTarget> targets;
  std::vector<JobFile> files; ///< files that are identical when the job is repeated

  bool operator==(const JobRecord&) const = default;
};

/// A file that a job reads.
struct JobInput {
  std::string name; ///< name used by the job, independent of the machine
  std::filesystem::path path;
};

/// Returns a checksum of everything that a result depends on: `description` (project, method,
/// parameters, seed, frames) and the input files. If an input is a folder, all files in it are
/// included. A file of up to 1 MB is included with its content, and a larger file with its size and
/// modification time. Returns FileMissing or FileUnreadable.
Result<std::string> jobKey(const std::string& description, const std::vector<JobInput>& inputs);

/// Returns the text of done.json.
std::string jobRecordText(const JobRecord& record);
/// Reads done.json. Errors: those of readJsonObject(), and MissingKey, WrongType or BadValue with
/// the name of the file and the field.
Result<JobRecord> readJobRecord(const std::filesystem::path& file);

} // namespace dewpoint::trajectory
