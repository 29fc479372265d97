// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "core/base/text_file.h"
#include "core/trajectory/jobs/gathered_jobs.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace dewpoint::app {
namespace {

struct GatherOptions {
  std::vector<std::string> folders;
  std::string list;
  std::string out;
};

/// The folders that are named, and those of the lines of --list.
Result<std::vector<std::string>> foldersOf(const GatherOptions& options) {
  std::vector<std::string> folders = options.folders;
  if (options.list.empty()) {
    return folders;
  }
  return readTextFile(options.list).map([&](const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (!line.empty()) {
        folders.push_back(line);
      }
    }
    return folders;
  });
}

Status writeGathered(const GatheredJobs& gathered, const std::filesystem::path& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) {
    return failure(ErrorCode::FileUnwritable, folder.string(), "--out", problem.message());
  }
  return writeTextFile(folder / "results.csv", gatheredTableText(gathered))
      .and_then(
          [&] { return writeTextFile(folder / "times.csv", gatheredDurationsText(gathered)); })
      .and_then([&] { return writeTextFile(folder / "report.md", gatheredReportText(gathered)); });
}

int gather(const GatherOptions& options) {
  const auto folders = foldersOf(options);
  if (!folders) {
    return reportError(folders.error());
  }
  const auto gathered = gatherJobs(*folders);
  if (!gathered) {
    return reportError(gathered.error());
  }
  if (const auto written = writeGathered(*gathered, options.out); !written) {
    return reportError(written.error());
  }
  for (const auto& [kept, other] : gathered->repeatedFolders) {
    fmt::print(stderr, "dewpoint-cli: note: {} has the same result as {}; it is counted once.\n",
               other, kept);
  }
  for (const std::string& folder : gathered->missingFolders) {
    fmt::print(stderr, "dewpoint-cli: note: {} is missing.\n", folder);
  }
  for (const std::string& folder : gathered->unfinishedFolders) {
    fmt::print(stderr, "dewpoint-cli: note: {} is unfinished.\n", folder);
  }
  fmt::print("{} results, {} missing, {} unfinished: {}\n", gathered->jobs.size(),
             gathered->missingFolders.size(), gathered->unfinishedFolders.size(),
             (std::filesystem::path(options.out) / "results.csv").string());
  return gathered->isComplete() ? kExitDone : kExitEndedEarly;
}

} // namespace

void addGatherCommand(CLI::App& app, int& exitCode) {
  auto* command =
      app.add_subcommand("gather", "Merge the output folders of many runs into one table.");
  auto options = std::make_shared<GatherOptions>();
  command->add_option("RUN", options->folders, "Output folders of track and people");
  command->add_option("--list", options->list, "File with more output folders, one per line");
  command
      ->add_option("--out", options->out, "Folder to write results.csv, times.csv and report.md to")
      ->required();
  command->callback([options, &exitCode] {
    if (options->folders.empty() && options->list.empty()) {
      throw CLI::RequiredError("RUN or --list");
    }
    exitCode = gather(*options);
  });
}

} // namespace dewpoint::app
