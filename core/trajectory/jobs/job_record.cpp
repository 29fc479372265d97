// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/jobs/job_record.h"

#include "core/base/limits.h"
#include "core/base/sha256.h"
#include "core/trajectory/jobs/json_fields.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>

namespace dewpoint::trajectory {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Up to this size a content is read at once, in less time than a program takes to start.
constexpr std::uintmax_t kSmallInput = 1U << 20U;

tl::unexpected<Error> unreadableInput(const fs::path& path, const std::error_code& problem) {
  return failure(ErrorCode::FileUnreadable, path.string(), "", problem.message());
}

/// One line for a file: its name, and its content or what stands for it.
Result<std::string> inputLine(const std::string& name, const fs::path& path) {
  std::error_code problem;
  const auto bytes = fs::file_size(path, problem);
  if (problem) {
    return unreadableInput(path, problem);
  }
  if (bytes <= kSmallInput) {
    return sha256OfFile(path).map(
        [&](const std::string& sum) { return fmt::format("{} sha256 {}\n", name, sum); });
  }
  const auto changed = fs::last_write_time(path, problem);
  if (problem) {
    return unreadableInput(path, problem);
  }
  return fmt::format("{} bytes {} changed {}\n", name, bytes,
                     static_cast<std::int64_t>(changed.time_since_epoch().count()));
}

/// The lines of the files of a folder: of each its size and when it was changed, for there may be
/// very many.
Result<std::string> folderLines(const std::string& name, const fs::path& folder) {
  std::vector<std::string> lines;
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    if (entry->is_regular_file(problem) && !problem) {
      const auto bytes = entry->file_size(problem);
      const auto changed = problem ? fs::file_time_type() : entry->last_write_time(problem);
      lines.push_back(fmt::format("{}/{} bytes {} changed {}\n", name,
                                  entry->path().filename().string(), bytes,
                                  static_cast<std::int64_t>(changed.time_since_epoch().count())));
    }
    if (problem) {
      break;
    }
  }
  if (problem) {
    return unreadableInput(folder, problem);
  }
  std::ranges::sort(lines);
  return fmt::format("{}", fmt::join(lines, ""));
}

constexpr int kMostThreads = 1'000'000;

Result<JobRecord> recordOf(const Json& json, const std::string& file) {
  JobRecord record;
  JsonFieldReader fields(json, file, "");
  JobIdentity& identity = record.identity;
  fields.readText("recording", identity.recordingName);
  fields.readText("command", identity.command);
  fields.readText("method", identity.method);
  fields.readInteger("seed", identity.seed, std::uint64_t{0}, std::uint64_t{UINT64_MAX});
  fields.readText("settings", identity.nonDefaultSettings);
  fields.readText("frame_range", identity.frameRange);
  fields.readText("version", identity.version);
  fields.readText("key", record.key);
  fields.readInteger("frames", record.frameCount, std::int64_t{0}, limits::kMaxFrames);
  fields.readNumber("seconds", record.trackingSeconds);
  fields.readInteger("threads", record.threadCount, 0, kMostThreads);
  if (const Json* targets = fields.findObjectArray("targets")) {
    for (const Json& one : *targets) {
      JsonFieldReader entry(one, file, "targets.");
      JobTarget& target = record.targets.emplace_back();
      entry.readText("name", target.name);
      entry.readInteger("valid_frames", target.validFrameCount, std::int64_t{0},
                        limits::kMaxFrames);
      fields.recordErrorOf(entry);
    }
  }
  if (const Json* files = fields.findObjectArray("files")) {
    for (const Json& one : *files) {
      JsonFieldReader entry(one, file, "files.");
      JobFile& written = record.files.emplace_back();
      entry.readText("name", written.name);
      entry.readInteger("bytes", written.byteCount, std::uintmax_t{0}, std::uintmax_t{UINTMAX_MAX});
      entry.readText("sha256", written.sha256);
      fields.recordErrorOf(entry);
    }
  }
  return fields.error() ? Result<JobRecord>(tl::make_unexpected(*fields.error()))
                        : Result<JobRecord>(std::move(record));
}

bool isInAnotherFolder(const JobFile& file) {
  return file.name.empty() || fs::path(file.name).filename() != file.name || file.name == "..";
}

} // namespace

Result<std::string> jobKey(const std::string& description, const std::vector<JobInput>& inputs) {
  std::string text = description + "\n";
  for (const JobInput& input : inputs) {
    std::error_code problem;
    if (!fs::exists(input.path, problem)) {
      return failure(ErrorCode::FileMissing, input.path.string(), "", "");
    }
    const auto lines = fs::is_directory(input.path, problem) ? folderLines(input.name, input.path)
                                                             : inputLine(input.name, input.path);
    if (!lines) {
      return lines;
    }
    text += *lines;
  }
  return sha256(text);
}

std::string jobRecordText(const JobRecord& record) {
  const JobIdentity& identity = record.identity;
  Json json;
  json["recording"] = identity.recordingName;
  json["command"] = identity.command;
  json["method"] = identity.method;
  json["seed"] = identity.seed;
  json["settings"] = identity.nonDefaultSettings;
  json["frame_range"] = identity.frameRange;
  json["version"] = identity.version;
  json["key"] = record.key;
  json["frames"] = record.frameCount;
  json["seconds"] = record.trackingSeconds;
  json["threads"] = record.threadCount;
  json["targets"] = Json::array();
  for (const JobTarget& target : record.targets) {
    json["targets"].push_back({{"name", target.name}, {"valid_frames", target.validFrameCount}});
  }
  json["files"] = Json::array();
  for (const JobFile& file : record.files) {
    json["files"].push_back(
        {{"name", file.name}, {"bytes", file.byteCount}, {"sha256", file.sha256}});
  }
  // A name from the command line can be any bytes.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<JobRecord> readJobRecord(const fs::path& file) {
  return readJsonObject(file.string()).and_then([&](const Json& json) {
    return recordOf(json, file.string()).and_then([&](JobRecord record) -> Result<JobRecord> {
      if (std::ranges::any_of(record.files, isInAnotherFolder)) {
        return failure(ErrorCode::BadValue, file.string(), "files", "a name is not that of a file");
      }
      return record;
    });
  });
}

} // namespace dewpoint::trajectory
