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

/// Owns a Session and converts its wake-ups (calls from the tracking thread when there is a new
/// snapshot) into a queued signal. At most one event waits in the queue, no matter how fast the
/// filter runs.
class SessionBridge : public QObject {
  Q_OBJECT
public:
  explicit SessionBridge(SessionInputs inputs, QObject* parent = nullptr);
  ~SessionBridge() override;

  Session& session() { return *session_; }
  /// Returns a snapshot for camera views, in which cameras without an image keep their last image
  /// for a while (LiveFrameFiller).
  TrackSnapshotPtr withMissingImagesFilled(const TrackSnapshotPtr& snapshot);
  /// Releases the session and stops its wake-ups, so that the caller can destroy the session in
  /// another thread.
  std::unique_ptr<Session> release();

Q_SIGNALS:
  void snapshotChanged(TrackSnapshotPtr snapshot);

private:
  void deliverNewest();

  std::atomic<bool> pending_ = false;
  std::unique_ptr<LiveFrameFiller> frameFiller_;
  // last member, so that it is destroyed before the members that its thread uses
  std::unique_ptr<Session> session_;
};

} // namespace dewpoint::ui
