// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jobs/latest_job.h"

#include <utility>

namespace dewpoint::ui {

namespace {
constexpr int kCancelTimeoutMs = 3000; ///< for canceled work to end while a newer one waits
} // namespace

LatestJob::LatestJob(SupersededJob overtaken, QObject* parent)
    : QObject(parent), superseded_(overtaken) {
  cancelTimeout_.setSingleShot(true);
  cancelTimeout_.setInterval(kCancelTimeoutMs);
  connect(&cancelTimeout_, &QTimer::timeout, &job_, &BackgroundJob::abandon);
  connect(&job_, &BackgroundJob::progressChanged, this, &LatestJob::progressChanged);
  connect(&job_, &BackgroundJob::ended, this, &LatestJob::startNext);
}

void LatestJob::start(BackgroundJob::Work work) {
  waiting_ = std::move(work);
  if (!job_.isRunning()) {
    startNext();
  } else if (superseded_ == SupersededJob::Dropped) {
    job_.cancel();
    if (!cancelTimeout_.isActive()) {
      cancelTimeout_.start();
    }
  }
}

void LatestJob::cancel() {
  waiting_.reset();
  cancelTimeout_.stop();
  job_.cancel();
}

void LatestJob::startNext() {
  if (job_.isRunning()) { // what the last one found has begun another one
    return;
  }
  cancelTimeout_.stop();
  if (waiting_) {
    job_.start(*std::exchange(waiting_, std::nullopt));
  } else {
    Q_EMIT becameIdle();
  }
}

} // namespace dewpoint::ui
