// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/background_job.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace dewpoint::ui {

/// A job of which only the newest order counts: while one is worked on, the last of the later
/// orders waits, and the others are never begun.
class LatestJob : public QObject {
  Q_OBJECT
public:
  /// What becomes of the work under way when a newer order comes.
  enum class Overtaken {
    Dropped, ///< it is canceled; when it does not notice within some seconds it is left behind
    Kept,    ///< it ends, and what it found is delivered: for views that follow a hand
  };
  explicit LatestJob(Overtaken overtaken, QObject* parent = nullptr);

  void start(BackgroundJob::Work work);
  /// Neither the work under way nor one that waits is wanted any more.
  void cancel();
  bool isRunning() const { return job_.isRunning(); }

Q_SIGNALS:
  void progressChanged(double part);
  /// Nothing runs any more, and nothing waits.
  void idle();

private:
  void goOn();

  Overtaken overtaken_;
  BackgroundJob job_;
  std::optional<BackgroundJob::Work> waiting_;
  QTimer cancelTimeout_;
};

} // namespace dewpoint::ui
