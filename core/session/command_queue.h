// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"
#include "core/tracking/tracker.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

namespace dewpoint::session {

/// Wishes of the user, passed by value to the tracking thread.
namespace command {
struct Play {};
struct Pause {};
struct StepFrame {};
struct StepIteration {};
struct Restart {
  std::optional<std::uint64_t> seed;
};
struct Configure {
  ParameterValues parameters;
};
struct SetMethod {
  std::string method;
  ParameterValues parameters;
  std::optional<std::int64_t> from; ///< nothing: from the start
};
struct ShowFrame {
  std::int64_t frame = 0;
};
struct BackToHead {};
struct Rerun {
  std::int64_t from = 0;
};
struct ShowMaps {
  bool wanted = false;
};
struct SetTargets {
  std::vector<Target> targets;
};
struct SetCameras {
  CameraRig rig;
};
struct SetEmptyRooms {
  std::vector<std::string> files; ///< as the project names them
  std::vector<cv::Mat> rooms;
};
struct ShowMasks {
  bool wanted = false;
};
struct ShowShapes {
  bool wanted = false;
};
/// Of methods for people: somebody stands somewhere, or is not there.
struct ChangePeople {
  struct Seen {
    int camera = 0;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  };
  std::optional<Eigen::Vector2d> place; ///< somebody stands here; world x and y, metres
  std::optional<Seen> seen;             ///< somebody is seen here
  std::optional<int> gone;              ///< this identity is not there
};
} // namespace command

using Command =
    std::variant<command::Play, command::Pause, command::StepFrame, command::StepIteration,
                 command::Restart, command::Configure, command::SetMethod, command::SetTargets,
                 command::SetCameras, command::SetEmptyRooms, command::ShowMasks,
                 command::ShowFrame, command::BackToHead, command::Rerun, command::ShowMaps,
                 command::ShowShapes, command::ChangePeople>;

/// Commands on their way to the tracking thread, in order.
class CommandQueue {
public:
  void push(Command command) {
    {
      const std::lock_guard lock(mutex_);
      // Of a row of moments to show, as a scrubbing hand asks for them, only the last is of use; so
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
