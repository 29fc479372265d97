// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/message/remote_command.h"

#include "core/base/sha256.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace dewpoint::broadcast {
namespace {

using nlohmann::json;

constexpr std::array<std::pair<const char*, RemoteAction>, 4> kActions{
    {{"start", RemoteAction::Start},
     {"stop", RemoteAction::Stop},
     {"record", RemoteAction::StartRecording},
     {"stop-recording", RemoteAction::StopRecording}}};

bool isRecordingName(std::string_view name) {
  constexpr std::string_view kAllowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
  return name.size() <= kMaxRecordingName &&
         name.find_first_not_of(kAllowed) == std::string_view::npos;
}

/// The text of a key; nothing if it has another type.
std::optional<std::string> jsonText(const json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) {
    return std::string();
  }
  return found->is_string() ? std::optional(found->get<std::string>()) : std::nullopt;
}

std::string replyText(const Status& done) {
  json answer{{"type", "reply"}, {"ok", done.has_value()}};
  if (!done) {
    answer["error"] = errorSentence(done.error());
  }
  return answer.dump(-1, ' ', false, json::error_handler_t::replace);
}

/// Whether brackets are nested deeper than any command needs: the parser uses stack memory.
bool isDeep(std::string_view text) {
  constexpr auto kDeepest = 8;
  return std::ranges::count_if(text, [](char c) { return c == '[' || c == '{'; }) > kDeepest;
}

} // namespace

bool areEqualInConstantTime(std::string_view a, std::string_view b) {
  // Checksums have one length: neither the length nor the first difference shows in the time.
  const std::string one = sha256(a);
  const std::string other = sha256(b);
  unsigned difference = 0;
  for (std::size_t k = 0; k < one.size(); ++k) {
    difference |= static_cast<unsigned char>(one[k]) ^ static_cast<unsigned char>(other[k]);
  }
  return difference == 0;
}

Result<RemoteCommand> parseRemoteCommand(std::string_view text) {
  if (text.size() > kMaxRemoteCommandBytes || isDeep(text)) {
    return failure(ErrorCode::NotParsed, "", "", "a short JSON object is expected");
  }
  const json read = json::parse(text, nullptr, false);
  if (!read.is_object()) {
    return failure(ErrorCode::NotParsed, "", "", "a JSON object is expected");
  }
  const auto command = jsonText(read, "command");
  const auto name = jsonText(read, "name");
  const auto token = jsonText(read, "token");
  const auto known = std::ranges::find_if(
      kActions, [&](const auto& one) { return command && *command == one.first; });
  if (known == kActions.end()) {
    return failure(ErrorCode::BadValue, "", "command",
                   "start, stop, record or stop-recording is expected");
  }
  if (!token) {
    return failure(ErrorCode::BadValue, "", "token", "a text is expected");
  }
  if (!name || !isRecordingName(*name)) {
    return failure(
        ErrorCode::BadValue, "", "name",
        fmt::format("up to {} letters, digits, - and _ are expected", kMaxRecordingName));
  }
  return RemoteCommand{known->second, *name, *token};
}

RemoteCommandFilter::RemoteCommandFilter(std::string token, RemoteReceiver receiver)
    : token_(std::move(token)), receiver_(std::move(receiver)) {}

std::string RemoteCommandFilter::handle(std::string_view line, Clock::time_point now) {
  if (!isOn()) {
    return {};
  }
  const auto command = parseRemoteCommand(line);
  return replyText(command ? execute(*command, now) : tl::make_unexpected(command.error()));
}

Status RemoteCommandFilter::execute(const RemoteCommand& command, Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  while (!wrong_.empty() && now - wrong_.front() > kLockoutTime) {
    wrong_.pop_front();
  }
  // A right token is refused too: else guessing could go on while it is locked.
  if (wrong_.size() >= kMaxWrongTokens) {
    return failure(ErrorCode::BadValue, "", "token",
                   fmt::format("too many wrong tokens; try again in {} s", kLockoutTime.count()));
  }
  if (!areEqualInConstantTime(command.token, token_)) {
    wrong_.push_back(now);
    return failure(ErrorCode::BadValue, "", "token", "it is wrong");
  }
  return receiver_(command);
}

} // namespace dewpoint::broadcast
