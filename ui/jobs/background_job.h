// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/job_thread.h"

#include <QObject>

#include <cstdint>
#include <functional>
#include <stop_token>

namespace dewpoint::ui {

/// One long calculation at a time in a thread of its own, beside a window that stays live. Nobody
/// waits for the thread, nor does the destructor: it only cancels.
class BackgroundJob : public QObject {
  Q_OBJECT
public:
  explicit BackgroundJob(QObject* parent = nullptr);
  ~BackgroundJob() override; ///< cancels; what is under way ends by itself, and unheard

  /// Says how far the work is (0 to 1; less than 0: unknown) and whether it is still wanted: when
  /// false comes back the work should end as soon as it can.
  using Progress = std::function<bool(double part)>;
  /// Runs in the job's thread, so it uses nothing but what it holds, not even the owner of the job;
  /// what it returns runs in the window's thread afterwards, unless the job was canceled or has
  /// gone meanwhile. Must not throw.
  using Work = std::function<std::function<void()>(const Progress& progress)>;

  /// False, and nothing is begun, while another one runs.
  bool start(Work work);
  void cancel(); ///< ended() follows when the work has noticed
  /// Cancels and does not wait for the work to notice: it has ended, and another one can start.
  void abandon();
  bool isRunning() const { return running_; }

Q_SIGNALS:
  void started();
  void progressChanged(double part); ///< at most about 20 times a second
  void ended(bool cancelled);        ///< after what the work returned has run

private:
  void end(const std::function<void()>& finish);

  JobMailbox mailbox_;
  bool running_ = false;
  std::uint64_t run_ = 0; ///< number of the work that is heard
  std::stop_source stop_;
};

} // namespace dewpoint::ui
