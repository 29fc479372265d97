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

/// What a program elsewhere may ask for.
enum class RemoteAction { Start, Stop, StartRecording, StopRecording };

/// A command from another program, as it was sent.
struct RemoteCommand {
  RemoteAction action = RemoteAction::Start;
  std::string name;  ///< name of the recording: letters, digits, - and _; may be empty
  std::string token; ///< what the sender claims to know
};

/// Longest line or WebSocket message that is read, in bytes.
inline constexpr std::size_t kMaxRemoteBytes = 4096;
/// Longest name of a recording, in bytes.
inline constexpr std::size_t kMaxRecordingName = 64;

/// Parses one JSON object: `{"command": "start", "token": "..."}`. The commands are start, stop,
/// record (with an optional "name") and stop-recording. BadValue or NotParsed names the key.
Result<RemoteCommand> parseRemoteCommand(std::string_view text);

/// Executes a command, whose token is right, and returns whether it worked. Called by the threads
/// of the outputs, one call at a time; it must not wait.
using RemoteReceiver = std::function<Status(const RemoteCommand&)>;

/// Decides which remote commands are executed. Thread-safe.
class RemoteGate {
public:
  using Clock = std::chrono::steady_clock;

  /// An empty token or receiver refuses everything.
  RemoteGate(std::string token, RemoteReceiver receiver);

  /// Handles a line from outside and returns the reply, one JSON object without a line end; empty
  /// if remote commands are off, so that nothing is revealed. After kMaxWrongTokens wrong tokens
  /// within kLockTime, from whatever sender, all commands are refused until the first of them is
  /// older than that.
  std::string handle(std::string_view line, Clock::time_point now = Clock::now());

  bool isOn() const { return !token_.empty() && receiver_ != nullptr; }

  static constexpr std::size_t kMaxWrongTokens = 5;
  static constexpr std::chrono::seconds kLockTime{60};

private:
  Status execute(const RemoteCommand& command, Clock::time_point now);

  std::string token_;
  RemoteReceiver receiver_;
  std::mutex mutex_;
  std::deque<Clock::time_point> wrong_; ///< times of wrong tokens, oldest first
};

/// Compares two texts in a time that depends on neither.
bool areEqualInConstantTime(std::string_view a, std::string_view b);

} // namespace dewpoint::broadcast
