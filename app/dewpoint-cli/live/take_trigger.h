// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/broadcast/message/remote_command.h"

#include <mutex>
#include <string>

namespace dewpoint::app {

/// Determines when a take (a recording of all cameras) starts and stops: at any line on standard
/// input, or at the remote commands `record` and `stop-recording`. receive() may be called by any
/// thread, the other functions by one thread only.
class TakeTrigger {
public:
  /// Handles a remote command. Returns BadValue for a command other than `record` and
  /// `stop-recording`, if `record` arrives after the take has started, and if `stop-recording`
  /// arrives while no take is in progress.
  Status receive(const broadcast::RemoteCommand& command);

  /// Returns whether the take must start now, without waiting.
  bool mustStartTake();
  /// Returns whether the take, which must have started, must stop now, without waiting.
  bool mustStopTake();
  /// Returns whether standard input has ended, so that no further line can arrive.
  bool hasInputEnded() const { return hasInputEnded_; }
  /// Returns the name that the remote command gave the take; empty if it gave none.
  std::string name() const;

private:
  enum class Stage { Waiting, Started, Stopped };

  /// Returns how many lines have come since the last call.
  int readPendingLines();

  mutable std::mutex mutex_; ///< guards `stage_` and `name_`
  Stage stage_ = Stage::Waiting;
  std::string name_;
  bool hasInputEnded_ = false;
};

} // namespace dewpoint::app
