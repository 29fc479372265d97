// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>

#include <atomic>
#include <memory>

namespace dewpoint::session {
class LiveFrameFiller;
class Session;
struct SessionInputs;
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// Owns a Session and turns its wake-ups, which come from the tracking thread, into one queued and
/// coalesced signal: however fast the filter runs, at most one event waits in the queue.
class SessionBridge : public QObject {
  Q_OBJECT
public:
  explicit SessionBridge(SessionInputs inputs, QObject* parent = nullptr);
  ~SessionBridge() override;

  Session& session() { return *session_; }
  /// What camera views show of a snapshot: see LiveFrameFiller.
  TrackSnapshotPtr asSeen(const TrackSnapshotPtr& snapshot);
  /// Hands the session over, silenced, so that its thread can be joined elsewhere.
  std::unique_ptr<Session> release();

Q_SIGNALS:
  void snapshotChanged(TrackSnapshotPtr snapshot);

private:
  void deliverNewest();

  std::atomic<bool> pending_ = false;
  std::unique_ptr<LiveFrameFiller> frameFiller_;
  std::unique_ptr<Session> session_; // last: destroyed first, before what its thread calls
};

} // namespace dewpoint::ui
