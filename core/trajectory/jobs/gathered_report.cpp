// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/statistics.h"
#include "core/base/units.h"
#include "core/trajectory/jobs/gathered_jobs.h"
#include "core/trajectory/jobs/gathered_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace dewpoint::trajectory {
namespace {

constexpr std::size_t kWorstRows = 10;

/// The results of one method with the same settings.
struct MethodGroup {
  std::size_t jobs = 0;
  std::set<std::string> recordings;
  std::int64_t frameCount = 0;
  std::vector<double> validFractions;
  std::vector<double> rmse; ///< meters
  std::vector<double> p95;  ///< meters
  std::vector<double> fractionInside95Ellipsoid;
};
using MethodName = std::tuple<std::string, std::string, std::string, std::string>;

/// Free texts in a cell of a Markdown table.
std::string markdownCell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) {
    text.replace(at, 1, "\\|");
  }
  std::ranges::replace(text, '\n', ' ');
  return text;
}

std::string percent(double share) {
  return fmt::format("{:.1f} %", inPercent(share));
}

std::string medianText(const std::vector<double>& meters) {
  return meters.empty() ? "" : fmt::format("{:.1f}", inMillimeters(median(meters)));
}

std::map<MethodName, MethodGroup> methodGroups(const GatheredJobs& gathered) {
  std::map<MethodName, MethodGroup> groups;
  const auto groupOf = [&](const GatheredJob& job) -> MethodGroup& {
    const JobIdentity& identity = job.record.identity;
    return groups[{identity.command, identity.method, identity.nonDefaultSettings,
                   identity.version}];
  };
  for (const GatheredJob& job : gathered.jobs) {
    MethodGroup& group = groupOf(job);
    ++group.jobs;
    group.recordings.insert(job.record.identity.recordingName);
    group.frameCount += job.record.frameCount;
  }
  for (const GatheredRow& row : gatheredRowsOf(gathered)) {
    MethodGroup& group = groupOf(*row.job);
    group.validFractions.push_back(row.validFraction());
    if (row.evaluation != nullptr) {
      group.rmse.push_back(row.evaluation->rmse);
      group.p95.push_back(row.evaluation->p95);
      group.fractionInside95Ellipsoid.push_back(row.evaluation->fractionInside95Ellipsoid);
    }
  }
  return groups;
}

std::string methodsTable(const GatheredJobs& gathered) {
  std::string text =
      "## Methods\n\nMedians over the runs and their targets.\n\n"
      "| command | method | settings | version | runs | recordings | frames | coverage | RMSE, mm "
      "| p95, mm | inside 95 % |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const auto& [name, group] : methodGroups(gathered)) {
    const auto& [command, method, settings, version] = name;
    text += fmt::format(
        "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", command, method,
        markdownCell(settings), version, group.jobs, group.recordings.size(), group.frameCount,
        percent(median(group.validFractions)), medianText(group.rmse), medianText(group.p95),
        group.fractionInside95Ellipsoid.empty() ? ""
                                                : percent(median(group.fractionInside95Ellipsoid)));
  }
  return text;
}

/// The first rows of those for which `worse` is larger, ties in the order of the table.
template <class Worse>
std::string worstTable(const char* title, std::vector<GatheredRow> rows, const Worse& worse) {
  std::ranges::stable_sort(rows, std::greater<>(), worse);
  rows.resize(std::min(rows.size(), kWorstRows));
  std::string text = fmt::format("\n## {}\n\n| recording | method | settings | seed | target | "
                                 "coverage | RMSE, mm |\n"
                                 "| --- | --- | --- | --- | --- | --- | --- |\n",
                                 title);
  for (const GatheredRow& row : rows) {
    const JobIdentity& identity = row.job->record.identity;
    text += fmt::format(
        "| {} | {} | {} | {} | {} | {} | {} |\n", markdownCell(identity.recordingName),
        identity.method, markdownCell(identity.nonDefaultSettings), identity.seed,
        markdownCell(row.target), percent(row.validFraction()),
        row.evaluation == nullptr ? ""
                                  : fmt::format("{:.1f}", inMillimeters(row.evaluation->rmse)));
  }
  return text;
}

std::string foldersText(const char* title, const std::vector<std::string>& folders) {
  if (folders.empty()) {
    return "";
  }
  std::string text = fmt::format("\n## {}\n\n", title);
  for (const std::string& folder : folders) {
    text += fmt::format("- `{}`\n", folder);
  }
  return text;
}

} // namespace

std::vector<GatheredRow> gatheredRowsOf(const GatheredJobs& gathered) {
  std::vector<GatheredRow> rows;
  for (const GatheredJob& job : gathered.jobs) {
    std::vector<JobTarget> targets = job.record.targets;
    std::ranges::sort(targets, {}, &JobTarget::name);
    if (targets.empty()) {
      rows.push_back({&job, "", 0, nullptr});
    }
    for (const JobTarget& target : targets) {
      const auto found = std::ranges::find(job.evaluations, target.name, &Evaluation::target);
      rows.push_back({&job, target.name, target.validFrameCount,
                      found == job.evaluations.end() ? nullptr : &*found});
    }
  }
  return rows;
}

std::string gatheredReportText(const GatheredJobs& gathered) {
  std::set<std::string> recordings;
  for (const GatheredJob& job : gathered.jobs) {
    recordings.insert(job.record.identity.recordingName);
  }
  std::string text = fmt::format("# Results\n\n{} runs of {} recordings; {} missing, {} "
                                 "unfinished.\n\n",
                                 gathered.jobs.size(), recordings.size(),
                                 gathered.missingFolders.size(), gathered.unfinishedFolders.size());
  text += methodsTable(gathered);
  const std::vector<GatheredRow> rows = gatheredRowsOf(gathered);
  text += worstTable("Least coverage", rows,
                     [](const GatheredRow& row) { return -row.validFraction(); });
  std::vector<GatheredRow> evaluated = rows;
  std::erase_if(evaluated, [](const GatheredRow& row) { return row.evaluation == nullptr; });
  if (!evaluated.empty()) {
    text += worstTable("Largest errors", evaluated,
                       [](const GatheredRow& row) { return row.evaluation->rmse; });
  }
  text += foldersText("Missing", gathered.missingFolders);
  text += foldersText("Unfinished", gathered.unfinishedFolders);
  return text;
}

} // namespace dewpoint::trajectory
