// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jobs/latest_job.h"

#include <utility>

namespace dewpoint::ui {

namespace {
constexpr int kPatienceMs = 3000; ///< with work that was cancelled, and keeps a newer one waiting
} // namespace

LatestJob::LatestJob(Overtaken overtaken, QObject* parent)
    : QObject(parent), overtaken_(overtaken) {
  patience_.setSingleShot(true);
  patience_.setInterval(kPatienceMs);
  connect(&patience_, &QTimer::timeout, &job_, &BackgroundJob::abandon);
  connect(&job_, &BackgroundJob::progressChanged, this, &LatestJob::progressChanged);
  connect(&job_, &BackgroundJob::ended, this, &LatestJob::goOn);
}

void LatestJob::start(BackgroundJob::Work work) {
  waiting_ = std::move(work);
  if (!job_.isRunning()) {
    goOn();
  } else if (overtaken_ == Overtaken::Dropped) {
    job_.cancel();
    if (!patience_.isActive()) {
      patience_.start();
    }
  }
}

void LatestJob::cancel() {
  waiting_.reset();
  patience_.stop();
  job_.cancel();
}

void LatestJob::goOn() {
  if (job_.isRunning()) { // what the last one found has begun another one
    return;
  }
  patience_.stop();
  if (waiting_) {
    job_.start(*std::exchange(waiting_, std::nullopt));
  } else {
    Q_EMIT idle();
  }
}

} // namespace dewpoint::ui
