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

/// How a command that tracks is called as one of many jobs.
struct JobOptions {
  std::string label;  ///< of the recording; empty: the project as it was named
  bool force = false; ///< do again what is done
};

void addJobOptions(CLI::App& command, JobOptions& options);

/// What a job will be called in gathered tables, and what its result depends on: `command` is that
/// of dewpoint-cli, `project` has all options applied, `more` says the others. Without a key where
/// the project's files cannot be read: what opens them says why.
JobRecord plannedJob(const std::string& command, const Project& project, const std::string& label,
                     const std::string& frames, const std::string& more);

/// Whether the folder has the result of this job already, which is then said.
bool isDoneAlready(const std::filesystem::path& folder, const JobRecord& job,
                   const JobOptions& options);

} // namespace dewpoint::app
