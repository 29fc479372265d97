// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_worker.h"

#include "ui/text/error_sentence.h"

namespace dewpoint::ui {

ExportWorker::ExportWorker(QObject* parent)
    : QObject(parent), thread_([this](const std::stop_token& stop) { work(stop); }) {}

ExportWorker::~ExportWorker() {
  cancelled_ = true;
  stopPreview();
  thread_.request_stop();
  thread_.join();
}

void ExportWorker::work(const std::stop_token& stop) {
  while (true) {
    Job job;
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, stop, [this] { return nextExport_ || nextPreview_; })) {
        return;
      }
      auto& next = nextExport_ ? nextExport_ : nextPreview_;
      job = std::move(*next);
      next.reset();
    }
    job();
  }
}

void ExportWorker::add(std::optional<Job>& place, Job job) {
  {
    const std::lock_guard lock(mutex_);
    place = std::move(job);
  }
  wake_.notify_one();
}

void ExportWorker::post(std::function<void()> say) {
  QMetaObject::invokeMethod(this, std::move(say), Qt::QueuedConnection);
}

void ExportWorker::preview(TrajectoryPtr trajectory, const ExportOptions& options,
                           const std::filesystem::path& file) {
  const unsigned number = ++wish_;
  add(nextPreview_, [this, number, trajectory = std::move(trajectory), options, file] {
    constexpr std::size_t kLines = 40;
    int shown = -1;
    const auto preview = previewExport(*trajectory, options, file, kLines, [&](double done) {
      if (const int percent = static_cast<int>(100.0 * done); percent != shown) {
        shown = percent;
        post([this, percent] { Q_EMIT previewing(percent); });
      }
      return number == wish_;
    });
    if (preview) {
      post([this, number, found = *preview] {
        if (number == wish_) {
          Q_EMIT previewReady(found);
        }
      });
    } else if (preview.error().code != ErrorCode::Cancelled) {
      post([this, error = preview.error()] { Q_EMIT previewFailed(errorSentence(error)); });
    }
  });
}

void ExportWorker::run(TrajectoryPtr trajectory, const ExportOptions& options,
                       const std::filesystem::path& file) {
  cancelled_ = false;
  stopPreview(); // it makes room
  add(nextExport_, [this, trajectory = std::move(trajectory), options, file] {
    int shown = -1;
    const auto progress = [&](double done) {
      const int percent = static_cast<int>(100.0 * done);
      if (percent != shown) {
        shown = percent;
        post([this, percent] { Q_EMIT progressChanged(percent); });
      }
      return !cancelled_;
    };
    const auto summary = exportTrajectory(*trajectory, options, file, progress);
    if (summary) {
      post([this, done = *summary] { Q_EMIT finished(done); });
    } else {
      post([this, error = summary.error()] { Q_EMIT failed(errorSentence(error)); });
    }
  });
}

void ExportWorker::run(std::function<Status()> task, const std::filesystem::path& file) {
  cancelled_ = false;
  add(nextExport_, [this, task = std::move(task), file] {
    const Status status = task();
    if (status) {
      ExportSummary summary;
      summary.files.push_back(file);
      post([this, summary] { Q_EMIT finished(summary); });
    } else {
      post([this, error = status.error()] { Q_EMIT failed(errorSentence(error)); });
    }
  });
}

} // namespace dewpoint::ui
