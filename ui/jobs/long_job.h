// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <stop_token>
#include <thread>

namespace dewpoint::ui {

/// One long calculation at a time in a thread of its own, beside a window that stays live.
class LongJob : public QObject {
  Q_OBJECT
public:
  explicit LongJob(QObject* parent = nullptr);
  ~LongJob() override; ///< cancels, and waits for what is under way

  /// Says how far the work is (0 to 1; less than 0: unknown) and whether it is still wanted: when
  /// false comes back the work should end as soon as it can.
  using Progress = std::function<bool(double part)>;
  /// Runs in the job's thread; what it returns runs in the window's thread afterwards, unless the
  /// job was cancelled meanwhile. Must not throw.
  using Work = std::function<std::function<void()>(const Progress& progress)>;

  /// False, and nothing is begun, while another one runs.
  bool start(Work work);
  void cancel(); ///< ended() follows when the work has noticed
  bool isRunning() const { return running_; }

Q_SIGNALS:
  void started();
  void progressChanged(double part); ///< at most about 20 times a second
  void ended(bool cancelled);        ///< after what the work returned has run

private:
  bool running_ = false;
  std::atomic<double> part_ = -1.0;
  std::jthread thread_; // last: it uses the rest
};

} // namespace dewpoint::ui
