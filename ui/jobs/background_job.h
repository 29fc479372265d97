// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/job_thread.h"

#include <QObject>

#include <cstdint>
#include <functional>
#include <stop_token>

namespace dewpoint::ui {

/// Runs one long computation at a time in another thread, so that the window stays responsive. The
/// window never waits for this thread; the destructor only cancels the work.
class BackgroundJob : public QObject {
  Q_OBJECT
public:
  explicit BackgroundJob(QObject* parent = nullptr);
  ~BackgroundJob() override; ///< cancels; running work ends later, and its result is discarded

  /// Function that reports the progress of the work (0 to 1; negative if unknown) and returns
  /// whether the result is still needed. If it returns false, the work should end as soon as
  /// possible.
  using Progress = std::function<bool(double part)>;
  /// Work to run in the job's thread. It may use only data that it owns; in particular, it must not
  /// use the owner of the job. The function that it returns then runs in the GUI thread, unless the
  /// job was canceled or deleted meanwhile. Must not throw.
  using Work = std::function<std::function<void()>(const Progress& progress)>;

  /// Starts the work. Returns false and does nothing while other work is running.
  bool start(Work work);
  void cancel(); ///< cancels the running work; `ended()` follows once the work has stopped
  /// Cancels the running work without waiting for the work to end. The job counts as ended, and new
  /// work can start.
  void abandon();
  bool isRunning() const { return running_; }

Q_SIGNALS:
  void started();
  /// Emitted with the progress of the work (0 to 1; negative if unknown), at most about 20 times a
  /// second.
  void progressChanged(double part);
  void ended(bool canceled); ///< emitted after the function returned by the work has run

private:
  void end(const std::function<void()>& finish);

  JobMailbox mailbox_;
  bool running_ = false;
  std::uint64_t run_ = 0; ///< number of the work whose result will be delivered
  std::stop_source stop_;
};

} // namespace dewpoint::ui
