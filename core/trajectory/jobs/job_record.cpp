// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/jobs/job_record.h"

#include "core/base/sha256.h"
#include "core/base/text_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

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

JobRecord recordOf(const Json& json) {
  JobRecord record;
  JobIdentity& identity = record.identity;
  json.at("recording").get_to(identity.recording);
  json.at("command").get_to(identity.command);
  json.at("method").get_to(identity.method);
  json.at("seed").get_to(identity.seed);
  json.at("settings").get_to(identity.settings);
  json.at("frame_range").get_to(identity.frames);
  json.at("version").get_to(identity.version);
  json.at("key").get_to(record.key);
  json.at("frames").get_to(record.frames);
  json.at("seconds").get_to(record.seconds);
  json.at("threads").get_to(record.threads);
  for (const Json& one : json.at("targets")) {
    record.targets.push_back({one.at("name"), one.at("valid_frames")});
  }
  for (const Json& one : json.at("files")) {
    record.files.push_back({one.at("name"), one.at("bytes"), one.at("sha256")});
  }
  return record;
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
  json["recording"] = identity.recording;
  json["command"] = identity.command;
  json["method"] = identity.method;
  json["seed"] = identity.seed;
  json["settings"] = identity.settings;
  json["frame_range"] = identity.frames;
  json["version"] = identity.version;
  json["key"] = record.key;
  json["frames"] = record.frames;
  json["seconds"] = record.seconds;
  json["threads"] = record.threads;
  json["targets"] = Json::array();
  for (const JobTarget& target : record.targets) {
    json["targets"].push_back({{"name", target.name}, {"valid_frames", target.validFrames}});
  }
  json["files"] = Json::array();
  for (const JobFile& file : record.files) {
    json["files"].push_back({{"name", file.name}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  }
  return json.dump(2) + "\n";
}

Result<JobRecord> readJobRecord(const fs::path& file) {
  const auto text = readTextFile(file);
  if (!text) {
    return tl::make_unexpected(text.error());
  }
  // The library's errors end here.
  try {
    JobRecord record = recordOf(Json::parse(*text));
    const auto isElsewhere = [](const JobFile& one) {
      return one.name.empty() || fs::path(one.name).filename() != one.name || one.name == "..";
    };
    if (std::ranges::any_of(record.files, isElsewhere)) {
      return failure(ErrorCode::BadValue, file.string(), "files", "a name is not that of a file");
    }
    return record;
  } catch (const Json::exception& error) {
    return failure(ErrorCode::NotParsed, file.string(), "", error.what());
  }
}

} // namespace dewpoint::trajectory
