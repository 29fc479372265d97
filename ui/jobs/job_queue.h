// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/job_thread.h"

#include <QObject>

#include <deque>
#include <functional>
#include <memory>
#include <mutex>

namespace dewpoint::ui {

/// Work that must be done in order and to the end, such as writing and removing files: everything
/// that was added is done, also when the queue is gone meanwhile. Nobody waits for it.
class JobQueue : public QObject {
  Q_OBJECT
public:
  explicit JobQueue(QObject* parent = nullptr);

  /// Runs in the queue's thread and uses nothing but what it holds; what it returns (nothing is
  /// fine) runs in the window's thread, unless the queue is gone by then. Must not throw.
  using Work = std::function<std::function<void()>()>;
  void add(Work work);

private:
  struct State {
    std::mutex mutex;
    std::deque<Work> waiting;
    bool running = false;
  };
  static void drain(State& state, const JobMailbox::Sender& mailbox);

  JobMailbox mailbox_;
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

} // namespace dewpoint::ui
