// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/common/repeated_job.h"

#include "core/project/project_files.h"
#include "core/trajectory/jobs/job_folder.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <vector>

namespace dewpoint::app {

void addJobOptions(CLI::App& command, JobOptions& options) {
  command.add_option("--label", options.label,
                     "Name of the recording in gathered tables (default: PROJECT)");
  command.add_flag("--force", options.repeatsFinishedJob,
                   "Track again even if the folder already contains the result");
}

JobRecord makeJobRecord(const std::string& command, const Project& project,
                        const std::string& label, const std::string& frames,
                        const std::string& more) {
  JobRecord job;
  job.identity = {
      label,  command,         project.method, project.seed, nonDefaultSettings(project),
      frames, DEWPOINT_VERSION};
  if (!isRepeatable(project)) {
    return job;
  }
  std::vector<JobInput> inputs;
  for (const ProjectFile& file : runInputFiles(project)) {
    inputs.push_back({file.name, file.path});
  }
  const std::string description = fmt::format("{}\n{}\n{}\n{}\n{}\n{}", command, DEWPOINT_VERSION,
                                              label, frames, more, runInputText(project));
  job.key = jobKey(description, inputs).value_or("");
  return job;
}

bool isAlreadyDone(const std::filesystem::path& folder, const JobRecord& job,
                   const JobOptions& options) {
  if (options.repeatsFinishedJob || !JobFolder::readFinishedRecord(folder, job.key)) {
    return false;
  }
  fmt::print("Nothing to do: {} already contains this result. Use --force to track again.\n",
             folder.string());
  return true;
}

} // namespace dewpoint::app
