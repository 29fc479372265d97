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

/// Input of Broadcaster::open(), which opens the outputs that send results to other programs.
struct BroadcastInputs {
  OutputSettings settings;
  std::filesystem::path folder = {}; ///< folder to which relative paths in the settings refer
  /// Volume of interest of the project, meters, world frame; it is sent to receivers as
  /// RigMessage::volume.
  std::optional<WorldBox> volume = {};
  /// Function that executes remote commands; empty: remote commands are off.
  RemoteReceiver receiver = {};
  PageTexts texts = {}; ///< texts of the page for browsers
};

/// Sends the results of a run to other programs while the run lasts. A separate thread sends them,
/// so tracking never waits. At most kQueueLength snapshots (results of one frame each) wait to be
/// sent; if there are more, the oldest is dropped.
class Broadcaster {
public:
  static constexpr std::size_t kQueueLength = 8;

  /// Opens all outputs that the settings in `inputs` describe. Errors name the key in the project
  /// file, for example "output.tcp".
  static Result<std::unique_ptr<Broadcaster>> open(const BroadcastInputs& inputs);
  /// Sends the snapshots (results of one frame each) that still wait to be sent, and closes all
  /// outputs.
  ~Broadcaster();
  Broadcaster(const Broadcaster&) = delete;
  Broadcaster& operator=(const Broadcaster&) = delete;

  /// Adds a snapshot (the results of one frame) to those that wait to be sent. Ignores a snapshot
  /// without results of newly tracked images. Returns immediately. Thread-safe.
  void enqueue(TrackSnapshotPtr snapshot);

  /// Sets the texts of the page for browsers. They are used when a browser loads the page the next
  /// time. Thread-safe.
  void setPageTexts(const PageTexts& texts);

  /// Returns the status of each open output, in the order JSON, WebSocket, OSC, TUIO, CSV.
  std::vector<OutletReport> reports() const;
  /// Returns the number of snapshots (results of one frame each) that were dropped because sending
  /// took too long.
  std::int64_t droppedFrameCount() const { return dropped_; }
  /// Returns the number of frames that were sent.
  std::int64_t sentFrameCount() const { return sent_; }

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
  WebServer* web_ = nullptr; ///< server of the page for browsers; null if there is none
  RateLimit limit_;
  // Of the thread:
  RecentPositions recent_;
  std::shared_ptr<const CameraRig> seenRig_; ///< rig from which the message `rig_` was made
  RigMessagePtr rig_;
  std::int64_t frame_ = -1;
  std::int64_t iterations_ = -1;

  std::mutex mutex_; ///< protects the queue of snapshots
  std::condition_variable_any arrived_;
  std::deque<TrackSnapshotPtr> queue_;
  std::atomic<std::int64_t> dropped_ = 0;
  std::atomic<std::int64_t> sent_ = 0;
  std::jthread thread_; // last: joined before the others go
};

} // namespace dewpoint::broadcast
