// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jobs/long_job.h"

#include <QMetaObject>

#include <chrono>
#include <utility>

namespace dewpoint::ui {

namespace {
/// Faster than this nobody reads a bar.
constexpr auto kBetweenReports = std::chrono::milliseconds(50);
} // namespace

LongJob::LongJob(QObject* parent) : QObject(parent) {}

LongJob::~LongJob() {
  thread_.request_stop();
}

bool LongJob::start(Work work) {
  if (running_) {
    return false;
  }
  if (thread_.joinable()) {
    thread_.join(); // it has posted its result already
  }
  running_ = true;
  Q_EMIT started();
  thread_ = std::jthread([this, work = std::move(work)](const std::stop_token& stop) {
    auto said = std::chrono::steady_clock::time_point();
    const auto finish = work([&](double part) {
      part_ = part;
      if (const auto now = std::chrono::steady_clock::now(); now - said >= kBetweenReports) {
        said = now;
        QMetaObject::invokeMethod(
            this, [this] { Q_EMIT progressChanged(part_); }, Qt::QueuedConnection);
      }
      return !stop.stop_requested();
    });
    QMetaObject::invokeMethod(
        this,
        [this, finish, stop] {
          const bool cancelled = stop.stop_requested();
          running_ = false;
          if (!cancelled && finish) {
            finish();
          }
          Q_EMIT ended(cancelled);
        },
        Qt::QueuedConnection);
  });
  return true;
}

void LongJob::cancel() {
  thread_.request_stop();
}

} // namespace dewpoint::ui
