// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jobs/job_queue.h"

#include <utility>

namespace dewpoint::ui {

JobQueue::JobQueue(QObject* parent) : QObject(parent) {}

void JobQueue::add(Work work) {
  {
    const std::scoped_lock lock(state_->mutex);
    state_->pendingWork.push_back(std::move(work));
    if (std::exchange(state_->isRunning, true)) {
      return;
    }
  }
  runDetached([state = state_, mailbox = mailbox_.sender()] { runWaiting(*state, mailbox); });
}

void JobQueue::runWaiting(State& state, const JobMailbox::Sender& mailbox) {
  while (true) {
    Work work;
    {
      const std::scoped_lock lock(state.mutex);
      if (state.pendingWork.empty()) {
        state.isRunning = false;
        return;
      }
      work = std::move(state.pendingWork.front());
      state.pendingWork.pop_front();
    }
    if (auto finish = work()) {
      mailbox.post(std::move(finish));
    }
  }
}

} // namespace dewpoint::ui
