// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/trajectory/jobs/job_record.h"

#include <filesystem>
#include <string>

namespace CLI { // NOLINT(readability-identifier-naming): the library's
class App;
} // namespace CLI

namespace dewpoint::app {

/// Options of a tracking command that is run as one of many jobs.
struct JobOptions {
  /// Label of the recording in combined tables; if empty, the project as named on the command line.
  std::string label;
  bool repeatsFinishedJob = false; ///< track again even if the result exists
};

/// Adds the command-line options that fill `options` to a command.
void addJobOptions(CLI::App& command, JobOptions& options);

/// Returns the record that identifies a job: its name in combined tables, and a key computed from
/// everything that its result depends on. `command` is the command of dewpoint-cli, `project` the
/// project with all options applied, and `more` a description of the other options. The key is
/// empty if the files of the project cannot be read; tracking then reports the error.
JobRecord makeJobRecord(const std::string& command, const Project& project,
                        const std::string& label, const std::string& frames,
                        const std::string& more);

/// Returns whether the folder already contains the result of this job; if so, prints a message.
bool isAlreadyDone(const std::filesystem::path& folder, const JobRecord& job,
                   const JobOptions& options);

} // namespace dewpoint::app
