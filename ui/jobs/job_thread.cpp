// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jobs/job_thread.h"

#include <QCoreApplication>
#include <QMetaObject>

#include <condition_variable>
#include <thread>
#include <utility>

namespace dewpoint::ui {

namespace {

/// The program lasts so much longer than its window while jobs are under way: a slow disk gets its
/// file, and no thread runs into the end of the process.
constexpr auto kPatienceAtEnd = std::chrono::seconds(10);

/// How many detached threads run.
struct Count {
  std::mutex mutex;
  std::condition_variable changed;
  int running = 0;
};

Count& count() {
  static auto* const theCount = new Count; // never destroyed: threads may outlive main()
  return *theCount;
}

} // namespace

void runDetached(std::function<void()> work) {
  static std::once_flag once;
  std::call_once(once, [] { qAddPostRoutine([] { (void)waitForDetachedJobs(kPatienceAtEnd); }); });
  Count& all = count();
  {
    const std::scoped_lock lock(all.mutex);
    ++all.running;
  }
  std::jthread([&all, work = std::move(work)]() mutable {
    work();
    work = nullptr; // what it holds goes before the thread counts as ended
    const std::scoped_lock lock(all.mutex);
    --all.running;
    all.changed.notify_all();
  }).detach();
}

bool waitForDetachedJobs(std::chrono::milliseconds patience) {
  Count& all = count();
  std::unique_lock lock(all.mutex);
  return all.changed.wait_for(lock, patience, [&] { return all.running == 0; });
}

JobMailbox::JobMailbox(QObject* parent) : QObject(parent) {
  sender_.state_->receiver = this;
}

JobMailbox::~JobMailbox() {
  std::deque<std::function<void()>> dropped; // destroyed without the lock
  const std::scoped_lock lock(sender_.state_->mutex);
  sender_.state_->receiver = nullptr;
  std::swap(dropped, sender_.state_->tasks);
}

void JobMailbox::Sender::post(std::function<void()> task) const {
  const std::scoped_lock lock(state_->mutex);
  if (state_->receiver != nullptr) {
    state_->tasks.push_back(std::move(task));
    QMetaObject::invokeMethod(state_->receiver, &JobMailbox::deliver, Qt::QueuedConnection);
  }
}

void JobMailbox::deliver() {
  std::function<void()> task;
  {
    const std::scoped_lock lock(sender_.state_->mutex);
    task = std::move(sender_.state_->tasks.front()); // a wake-up for each task
    sender_.state_->tasks.pop_front();
  }
  task(); // may delete this mailbox
}

} // namespace dewpoint::ui
