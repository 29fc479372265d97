// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

namespace dewpoint::broadcast {

/// Action that another program can request.
enum class RemoteAction { Start, Stop, StartRecording, StopRecording };

/// Command from another program, before its token is checked.
struct RemoteCommand {
  RemoteAction action = RemoteAction::Start;
  std::string name;  ///< name of the recording: letters, digits, - and _; may be empty
  std::string token; ///< secret word with which the sender proves its permission
};

/// Maximum length of a line or WebSocket message that contains a remote command, bytes. Longer ones
/// are rejected.
inline constexpr std::size_t kMaxRemoteCommandBytes = 4096;
/// Maximum length of the name of a recording, bytes.
inline constexpr std::size_t kMaxRecordingName = 64;

/// Parses one JSON object: `{"command": "start", "token": "..."}`. The commands are start, stop,
/// record (with an optional "name") and stop-recording. Errors: NotParsed if the text is not a
/// short JSON object; BadValue, which names the invalid key.
Result<RemoteCommand> parseRemoteCommand(std::string_view text);

/// Function that executes a command whose token was correct. Returns an error if this fails. It is
/// called in the threads of the outputs, by one thread at a time, and must return immediately.
using RemoteReceiver = std::function<Status(const RemoteCommand&)>;

/// Checks the tokens of remote commands and executes the permitted commands. Thread-safe.
class RemoteCommandFilter {
public:
  using Clock = std::chrono::steady_clock;

  /// `token`: secret word that commands must contain. If the token or the receiver is empty, remote
  /// commands are off.
  RemoteCommandFilter(std::string token, RemoteReceiver receiver);

  /// Executes the command in a line that was received, if its token is correct. Returns the reply:
  /// one JSON object without a line end. The reply is empty if remote commands are off.
  ///
  /// After kMaxWrongTokens wrong tokens within kLockoutTime, from any senders, all commands are
  /// refused until the first of these tokens is older than kLockoutTime.
  std::string handle(std::string_view line, Clock::time_point now = Clock::now());

  /// Returns whether remote commands are on.
  bool isOn() const { return !token_.empty() && receiver_ != nullptr; }

  static constexpr std::size_t kMaxWrongTokens = 5;
  static constexpr std::chrono::seconds kLockoutTime{60};

private:
  Status execute(const RemoteCommand& command, Clock::time_point now);

  std::string token_;
  RemoteReceiver receiver_;
  std::mutex mutex_;
  std::deque<Clock::time_point> wrong_; ///< times of wrong tokens, oldest first
};

/// Returns whether two texts are equal. The time of the comparison does not depend on where they
/// differ, so an attacker cannot measure how much of a guess is correct.
bool areEqualInConstantTime(std::string_view a, std::string_view b);

} // namespace dewpoint::broadcast
