// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/jobs/gathered_jobs.h"

#include "core/base/limits.h"
#include "core/base/units.h"
#include "core/trajectory/csv_line.h"
#include "core/trajectory/evaluation_text.h"
#include "core/trajectory/jobs/gathered_rows.h"
#include "core/trajectory/jobs/job_folder.h"
#include "core/trajectory/jobs/json_fields.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <tuple>

namespace dewpoint::trajectory {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTrajectoryChecksumKey = "trajectory_sha256";

Evaluation evaluationOf(const nlohmann::ordered_json& json, JsonFieldReader& file,
                        const std::string& name) {
  Evaluation one;
  JsonFieldReader fields(json, name, "targets.");
  fields.readText("target", one.target);
  fields.readNumber("rmse", one.rmse);
  fields.readNumber("median", one.medianError);
  fields.readNumber("p95", one.p95);
  fields.readNumber("max", one.maxError);
  fields.readNumber("rmse_all", one.rmseOfAllFrames);
  fields.readNumber("inside_95", one.fractionInside95Ellipsoid);
  constexpr std::int64_t kNone = 0;
  fields.readInteger("frames_compared", one.comparedFrameCount, kNone, limits::kMaxFrames);
  fields.readInteger("lost_frames", one.lostFrameCount, kNone, limits::kMaxFrames);
  fields.readInteger("missing", one.missingFrameCount, kNone, limits::kMaxFrames);
  fields.readInteger("frames_to_converge", one.convergenceFrameCount, kNone, limits::kMaxFrames);
  file.recordErrorOf(fields);
  return one;
}

/// The evaluation in a folder; empty where there is none.
Result<std::vector<Evaluation>> evaluationsIn(const fs::path& folder, const JobRecord& record) {
  const fs::path file = folder / kEvaluationFile;
  std::error_code problem;
  if (!fs::exists(file, problem)) {
    return {};
  }
  const auto json = readJsonObject(file.string());
  if (!json) {
    return tl::make_unexpected(json.error());
  }
  JsonFieldReader fields(*json, file.string(), "");
  std::string checksum;
  fields.readText(kTrajectoryChecksumKey, checksum);
  std::vector<Evaluation> evaluations;
  if (const auto* targets = fields.findObjectArray("targets")) {
    for (const auto& one : *targets) {
      evaluations.push_back(evaluationOf(one, fields, file.string()));
    }
  }
  if (fields.error()) {
    return tl::make_unexpected(*fields.error());
  }
  if (std::ranges::find(record.files, checksum, &JobFile::sha256) == record.files.end()) {
    return failure(ErrorCode::Mismatch, file.string(), kTrajectoryChecksumKey,
                   "it was made from another trajectory than the one in this folder: evaluate "
                   "the run again");
  }
  return evaluations;
}

/// Whether all files of a finished job are there with their sizes.
bool areFilesComplete(const fs::path& folder, const JobRecord& record) {
  return std::ranges::all_of(record.files, [&](const JobFile& file) {
    std::error_code problem;
    return fs::file_size(folder / file.name, problem) == file.byteCount && !problem;
  });
}

/// The job of a folder; nothing where it has not finished.
Result<std::optional<GatheredJob>> jobIn(const std::string& name) {
  const fs::path folder = name;
  std::error_code problem;
  if (!fs::exists(folder / kDoneFile, problem)) {
    return std::nullopt;
  }
  auto record = readJobRecord(folder / kDoneFile);
  if (!record) {
    return tl::make_unexpected(record.error());
  }
  if (!areFilesComplete(folder, *record)) {
    return std::nullopt;
  }
  return evaluationsIn(folder, *record).map([&](std::vector<Evaluation> evaluations) {
    return std::optional(GatheredJob{name, std::move(*record), std::move(evaluations)});
  });
}

/// The order of jobs; of the same job, one with an evaluation comes first.
auto orderOf(const GatheredJob& job) {
  return std::make_tuple(job.record.identity, job.evaluations.empty(), job.folder);
}

/// Keeps each job once.
Status mergeRepeated(GatheredJobs& gathered) {
  std::vector<GatheredJob> once;
  for (GatheredJob& job : gathered.jobs) {
    if (once.empty() || once.back().record.identity != job.record.identity) {
      once.push_back(std::move(job));
      continue;
    }
    if (once.back().record.files != job.record.files) {
      return failure(ErrorCode::Mismatch, job.folder, kDoneFile,
                     "it has a different result of the same job than " + once.back().folder);
    }
    gathered.repeatedFolders.emplace_back(once.back().folder, job.folder);
  }
  gathered.jobs = std::move(once);
  return {};
}

void putIdentity(const JobIdentity& identity, CsvLine& line) {
  line.put(identity.recordingName)
      .put(identity.command)
      .put(identity.method)
      .put(identity.nonDefaultSettings);
  line.put(identity.frameRange).put(identity.seed);
}

void putNothing(CsvLine& line, int cells) {
  for (int k = 0; k < cells; ++k) {
    line.put(std::string_view());
  }
}

} // namespace

Result<GatheredJobs> gatherJobs(const std::vector<std::string>& folders) {
  GatheredJobs gathered;
  // A folder that is named twice is one folder.
  for (const std::string& name : std::set<std::string>(folders.begin(), folders.end())) {
    std::error_code problem;
    if (!fs::is_directory(name, problem)) {
      gathered.missingFolders.push_back(name);
      continue;
    }
    auto job = jobIn(name);
    if (!job) {
      return tl::make_unexpected(job.error());
    }
    if (*job) {
      gathered.jobs.push_back(std::move(**job));
    } else {
      gathered.unfinishedFolders.push_back(name);
    }
  }
  std::ranges::sort(gathered.jobs, {}, orderOf);
  if (const auto merged = mergeRepeated(gathered); !merged) {
    return tl::make_unexpected(merged.error());
  }
  return gathered;
}

std::string evaluationFileText(const std::vector<Evaluation>& evaluations,
                               const std::string& trajectorySha256) {
  nlohmann::json json = evaluationJson(evaluations);
  json[kTrajectoryChecksumKey] = trajectorySha256;
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string gatheredTableText(const GatheredJobs& gathered) {
  std::string text =
      "recording,command,method,settings,frame_range,seed,target,frames,coverage,frames_compared,"
      "rmse_mm,median_mm,p95_mm,max_mm,rmse_all_mm,inside_95,frames_to_converge,lost_frames,"
      "version\n";
  for (const GatheredRow& row : gatheredRowsOf(gathered)) {
    CsvLine line(text);
    putIdentity(row.job->record.identity, line);
    line.put(row.target).put(row.job->record.frameCount).put(row.validFraction());
    if (row.evaluation != nullptr) {
      const Evaluation& e = *row.evaluation;
      line.put(e.comparedFrameCount);
      for (const double length : {e.rmse, e.medianError, e.p95, e.maxError, e.rmseOfAllFrames}) {
        line.put(inMillimeters(length));
      }
      line.put(e.fractionInside95Ellipsoid);
      if (e.convergenceFrameCount) {
        line.put(*e.convergenceFrameCount);
      } else {
        putNothing(line, 1);
      }
      line.put(e.lostFrameCount);
    } else {
      putNothing(line, 9);
    }
    line.put(row.job->record.identity.version);
  }
  return text;
}

std::string gatheredDurationsText(const GatheredJobs& gathered) {
  std::string text = "recording,command,method,settings,frame_range,seed,frames,seconds,"
                     "frames_per_second,threads\n";
  for (const GatheredJob& job : gathered.jobs) {
    const JobRecord& record = job.record;
    CsvLine line(text);
    putIdentity(record.identity, line);
    line.put(record.frameCount).put(record.trackingSeconds);
    line.put(record.trackingSeconds > 0.0
                 ? static_cast<double>(record.frameCount) / record.trackingSeconds
                 : 0.0);
    line.put(record.threadCount);
  }
  return text;
}

} // namespace dewpoint::trajectory
