// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/broadcast/format/stream_formats.h"
#include "core/broadcast/message/frame_message.h"
#include "core/broadcast/message/remote_command.h"
#include "core/broadcast/rate_limit.h"
#include "core/broadcast/transport/outlet.h"
#include "core/broadcast/transport/page_texts.h"
#include "core/project/output_settings.h"
#include "core/session/snapshot/snapshot.h"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace dewpoint::broadcast {

class WebServer;

/// Everything that outputs are opened with.
struct BroadcastInputs {
  OutputSettings settings;
  std::filesystem::path folder = {};   ///< relative paths are relative to it
  std::optional<WorldBox> volume = {}; ///< RigMessage::volume, meters, world frame
  RemoteReceiver receiver = {};        ///< empty: remote commands are off
  PageTexts texts = {};                ///< of the page for browsers
};

/// Sends the results of a run to other programs while it runs. It has its own thread, and tracking
/// never waits for it: up to kQueueLength snapshots wait, and the oldest are dropped.
class Broadcaster {
public:
  static constexpr std::size_t kQueueLength = 8;

  /// Opens all outputs of the settings. Errors name the key of the project file, as "output.tcp".
  static Result<std::unique_ptr<Broadcaster>> open(const BroadcastInputs& inputs);
  /// Sends what still waits, and closes all outputs.
  ~Broadcaster();
  Broadcaster(const Broadcaster&) = delete;
  Broadcaster& operator=(const Broadcaster&) = delete;

  /// Offers a snapshot. Those without newly tracked images are ignored. Returns at once; may be
  /// called by any thread.
  void offer(TrackSnapshotPtr snapshot);

  /// Sets the texts of the page for browsers, for pages that are loaded from now on. May be called
  /// by any thread.
  void setPageTexts(const PageTexts& texts);

  /// Returns how each output is doing, in the order JSON, WebSocket, OSC, TUIO, CSV.
  std::vector<OutletReport> reports() const;
  /// Returns how many snapshots were dropped because sending took too long.
  std::int64_t droppedFrames() const { return dropped_; }
  /// Returns how many frames were sent.
  std::int64_t sentFrames() const { return sent_; }

private:
  struct Line {
    const StreamFormat* format = nullptr;
    std::unique_ptr<Outlet> outlet;
  };

  Broadcaster(const BroadcastInputs& inputs, std::vector<Line> lines, WebServer* web);
  void run(const std::stop_token& stop);
  void send(const TrackSnapshot& snapshot);
  void updateRig(const TrackSnapshot& snapshot);

  OutputCoordinates coordinates_;
  std::optional<WorldBox> volume_;
  std::vector<Line> lines_;
  WebServer* web_ = nullptr; ///< one of `lines_`, if there is a page
  RateLimit limit_;
  // Of the thread:
  RecentPositions recent_;
  std::shared_ptr<const CameraRig> seenRig_; ///< the one that `rig_` was made of
  RigMessagePtr rig_;
  std::int64_t frame_ = -1;
  std::int64_t iterations_ = -1;

  std::mutex mutex_; ///< of the queue
  std::condition_variable_any arrived_;
  std::deque<TrackSnapshotPtr> queue_;
  std::atomic<std::int64_t> dropped_ = 0;
  std::atomic<std::int64_t> sent_ = 0;
  std::jthread thread_; // last: joined before the others go
};

} // namespace dewpoint::broadcast
