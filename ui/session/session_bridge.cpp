// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/session_bridge.h"

#include "core/session/session.h"
#include "core/session/snapshot/live_frame_filler.h"
#include "ui/session/project_loader.h"

#include <QMetaObject>

namespace dewpoint::ui {

SessionBridge::SessionBridge(SessionInputs inputs, QObject* parent)
    : QObject(parent), frameFiller_(std::make_unique<LiveFrameFiller>()),
      session_(std::make_unique<Session>(std::move(inputs))) {
  session_->onSnapshot([this] {
    if (!pending_.exchange(true)) {
      QMetaObject::invokeMethod(this, &SessionBridge::deliverNewest, Qt::QueuedConnection);
    }
  });
}

SessionBridge::~SessionBridge() {
  ProjectLoader::destroyInBackground(release()); // its threads may hang in a dead camera
}

TrackSnapshotPtr SessionBridge::withMissingImagesFilled(const TrackSnapshotPtr& snapshot) {
  return frameFiller_->withMissingImages(snapshot);
}

std::unique_ptr<Session> SessionBridge::release() {
  if (session_) {
    session_->onSnapshot({});
    session_->pause();
  }
  return std::move(session_);
}

void SessionBridge::deliverNewest() {
  // Cleared before reading: what is published from here on earns a wake-up of its own.
  pending_ = false;
  if (session_) {
    Q_EMIT snapshotChanged(session_->newest());
  }
}

} // namespace dewpoint::ui
