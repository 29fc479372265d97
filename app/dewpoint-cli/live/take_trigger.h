// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/broadcast/message/remote_command.h"

#include <mutex>
#include <string>

namespace dewpoint::app {

/// Starts and stops a take: by lines of standard input, whatever is in them, and by the remote
/// commands `record` and `stop-recording`. receive() may be called by any thread, the other
/// functions by one thread.
class TakeTrigger {
public:
  /// Executes a remote command. BadValue if it does not fit: another command, a take that is in
  /// progress, or none.
  Status receive(const broadcast::RemoteCommand& command);

  /// Returns whether the take is to start now. Does not wait.
  bool takeStart();
  /// Returns whether the take, which has started, is to stop now. Does not wait.
  bool takeStop();
  /// Returns whether standard input has ended, so that no line can come any more.
  bool hasInputEnded() const { return hasInputEnded_; }
  /// Returns the name in the remote command that started the take; empty if it had none.
  std::string name() const;

private:
  enum class Stage { Waiting, Started, Stopped };

  /// Returns how many lines have come since the last call.
  int takeLines();

  mutable std::mutex mutex_; ///< guards `stage_` and `name_`
  Stage stage_ = Stage::Waiting;
  std::string name_;
  bool hasInputEnded_ = false;
};

} // namespace dewpoint::app
