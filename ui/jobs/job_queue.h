// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/job_thread.h"

#include <QObject>

#include <deque>
#include <functional>
#include <memory>
#include <mutex>

namespace dewpoint::ui {

/// Runs work, such as writing files, in another thread, in order and to completion. All added work
/// is done, even if the queue is deleted meanwhile. The window never waits for the work.
class JobQueue : public QObject {
  Q_OBJECT
public:
  explicit JobQueue(QObject* parent = nullptr);

  /// Work to run in the queue's thread. It may use only data that it owns. The function it returns
  /// (may be empty) runs in the GUI thread, unless the queue was deleted meanwhile. Must not throw.
  using Work = std::function<std::function<void()>()>;
  void add(Work work);

private:
  struct State {
    std::mutex mutex;
    std::deque<Work> pendingWork;
    bool isRunning = false;
  };
  static void runWaiting(State& state, const JobMailbox::Sender& mailbox);

  JobMailbox mailbox_;
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

} // namespace dewpoint::ui
