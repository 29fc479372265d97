// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jobs/background_job.h"

#include <chrono>
#include <memory>
#include <utility>

namespace dewpoint::ui {

namespace {
/// Faster than this nobody reads a bar.
constexpr auto kBetweenReports = std::chrono::milliseconds(50);
} // namespace

BackgroundJob::BackgroundJob(QObject* parent) : QObject(parent) {}

BackgroundJob::~BackgroundJob() {
  stop_.request_stop();
}

bool BackgroundJob::start(Work work) {
  if (running_) {
    return false;
  }
  running_ = true;
  stop_ = std::stop_source();
  const std::uint64_t run = ++run_;
  Q_EMIT started();
  runDetached([this, run, mailbox = mailbox_.sender(), stop = stop_.get_token(),
               work = std::move(work)]() mutable {
    auto reported = std::chrono::steady_clock::time_point();
    auto finish = std::make_shared<std::function<void()>>(work([&](double part) {
      if (const auto now = std::chrono::steady_clock::now(); now - reported >= kBetweenReports) {
        reported = now;
        mailbox.post([this, run, part] {
          if (run == run_ && running_) {
            Q_EMIT progressChanged(part);
          }
        });
      }
      return !stop.stop_requested();
    }));
    work = nullptr; // it may hold much, and nobody needs it any more
    mailbox.post([this, run, finish = std::move(finish)] {
      if (run == run_ && running_) {
        end(*finish);
      }
    });
  });
  return true;
}

void BackgroundJob::end(const std::function<void()>& finish) {
  const bool canceled = stop_.stop_requested();
  running_ = false;
  if (!canceled && finish) {
    finish();
  }
  Q_EMIT ended(canceled);
}

void BackgroundJob::cancel() {
  stop_.request_stop();
}

void BackgroundJob::abandon() {
  stop_.request_stop();
  if (running_) {
    ++run_;
    end({});
  }
}

} // namespace dewpoint::ui
