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

/// Commands on their way to the tracking thread, in order.
class CommandQueue {
public:
  void push(Command command) {
    {
      const std::lock_guard lock(mutex_);
      // Of several frames to show, as scrubbing requests them, only the last is of use; so
      // it is with poses of cameras that are dragged.
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
  /// The next command; waits until `deadline` for one (for ever without a deadline), or until
  /// stopped.
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
