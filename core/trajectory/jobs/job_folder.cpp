// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/jobs/job_folder.h"

#include "core/base/sha256.h"
#include "core/base/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <random>

namespace dewpoint::trajectory {
namespace {

namespace fs = std::filesystem;

/// Different for each job of all machines.
std::string newToken() {
  std::random_device chance;
  const auto now = std::chrono::system_clock::now().time_since_epoch().count();
  return fmt::format("This job has not finished, or was killed: its results are not complete.\n"
                     "{} {:08x}{:08x}\n",
                     now, chance(), chance());
}

Result<JobFile> jobFile(const fs::path& folder, const std::string& name) {
  std::error_code problem;
  const auto bytes = fs::file_size(folder / name, problem);
  return sha256OfFile(folder / name).map([&](std::string sum) {
    return JobFile{name, bytes, std::move(sum)};
  });
}

/// Whether a file is as a job has left it, by its size.
bool isThere(const fs::path& folder, const JobFile& file) {
  std::error_code problem;
  return fs::file_size(folder / file.name, problem) == file.byteCount && !problem;
}

} // namespace

std::optional<JobRecord> JobFolder::readFinishedRecord(const fs::path& folder,
                                                       const std::string& key) {
  auto record = readJobRecord(folder / kDoneFile);
  if (!record || key.empty() || record->key != key) {
    return std::nullopt;
  }
  const bool isWhole = std::ranges::all_of(
      record->files, [&](const JobFile& file) { return isThere(folder, file); });
  return isWhole ? std::optional(std::move(*record)) : std::nullopt;
}

Result<JobFolder> JobFolder::beginJob(const fs::path& folder,
                                      const std::vector<std::string>& names) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  const auto former = readJobRecord(folder / kDoneFile);
  if (!problem) {
    fs::remove(folder / kDoneFile, problem);
  }
  if (problem) {
    return failure(ErrorCode::FileUnwritable, folder.string(), "", problem.message());
  }
  // Removed, not emptied: where another process still writes them, it does so into nothing.
  std::vector<std::string> removed = names;
  removed.emplace_back(kEvaluationFile);
  for (const std::string& name : removed) {
    if (fs::is_regular_file(folder / name, problem)) {
      fs::remove(folder / name, problem);
    }
  }
  for (const JobFile& file : former ? former->files : std::vector<JobFile>()) {
    if (isThere(folder, file)) { // else it is somebody else's by now
      fs::remove(folder / file.name, problem);
    }
  }
  JobFolder job(folder, newToken());
  return writeTextFile(folder / kUnfinishedFile, job.token_).map([&] { return job; });
}

Status JobFolder::finish(JobRecord record, const std::vector<std::string>& names) const {
  const auto token = readTextFile(folder_ / kUnfinishedFile);
  if (!token || *token != token_) {
    return failure(ErrorCode::FileUnwritable, (folder_ / kDoneFile).string(), "",
                   "another job has started in this folder in the meantime");
  }
  record.files.clear();
  for (const std::string& name : names) {
    auto file = jobFile(folder_, name);
    if (!file) {
      return tl::make_unexpected(file.error());
    }
    record.files.push_back(std::move(*file));
  }
  return writeTextFile(folder_ / kDoneFile, jobRecordText(record)).map([&] {
    std::error_code ignored;
    fs::remove(folder_ / kUnfinishedFile, ignored);
  });
}

} // namespace dewpoint::trajectory
