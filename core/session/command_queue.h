// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/command.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>
#include <variant>

namespace dewpoint::session {

/// Thread-safe first-in, first-out queue of commands for the tracking thread.
class CommandQueue {
public:
  void push(Command command) {
    {
      const std::lock_guard lock(mutex_);
      // While the user scrubs through frames or drags a camera, only the last requested frame or
      // camera pose is needed.
      const bool replaces = std::holds_alternative<command::ShowFrame>(command) ||
                            std::holds_alternative<command::SetCameras>(command);
      if (replaces && !commands_.empty() && commands_.back().index() == command.index()) {
        commands_.pop_back();
      }
      commands_.push_back(std::move(command));
    }
    wake_.notify_one();
  }
  bool empty() const {
    const std::lock_guard lock(mutex_);
    return commands_.empty();
  }
  /// Removes the next command from the queue and returns it. If the queue is empty, waits until
  /// `deadline`, or indefinitely if there is no deadline. Returns nothing if the deadline passes or
  /// a stop is requested.
  std::optional<Command> pop(const std::stop_token& stop,
                             std::optional<std::chrono::steady_clock::time_point> deadline) {
    std::unique_lock lock(mutex_);
    const auto ready = [this] { return !commands_.empty(); };
    const bool found =
        deadline ? wake_.wait_until(lock, stop, *deadline, ready) : wake_.wait(lock, stop, ready);
    if (!found) {
      return std::nullopt;
    }
    Command command = std::move(commands_.front());
    commands_.pop_front();
    return command;
  }

private:
  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  std::deque<Command> commands_;
};

} // namespace dewpoint::session
