// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/background_job.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace dewpoint::ui {

/// Job for which only the newest request counts. While one request is being processed, only the
/// newest of the later requests waits; the others are dropped.
class LatestJob : public QObject {
  Q_OBJECT
public:
  /// What happens to running work when a newer request arrives.
  enum class SupersededJob {
    Dropped, ///< canceled; abandoned if it does not end within a few seconds
    Kept,    ///< completed, and its result is delivered; for views that follow a drag
  };
  explicit LatestJob(SupersededJob overtaken, QObject* parent = nullptr);

  void start(BackgroundJob::Work work);
  /// Cancels the running work and the waiting request.
  void cancel();
  bool isRunning() const { return job_.isRunning(); }

Q_SIGNALS:
  void progressChanged(double part);
  /// Emitted when no work is running or waiting.
  void becameIdle();

private:
  void startNext();

  SupersededJob superseded_;
  BackgroundJob job_;
  std::optional<BackgroundJob::Work> waiting_;
  QTimer cancelTimeout_;
};

} // namespace dewpoint::ui
