// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/broadcaster.h"
#include "ui/jobs/background_job.h"
#include "ui/workbench/workbench.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>
#include <future>
#include <memory>
#include <utility>
#include <vector>

class QLabel;

namespace dewpoint::ui {

/// Sends the results of the run to other programs, through the outputs in the project's settings.
/// Nothing is sent until the user switches sending on (actionSendResults). When the settings
/// change, the outputs are opened again. Remote commands that contain the right token can play,
/// pause and record (recordingRequested()).
class OutputController : public QObject {
  Q_OBJECT
public:
  /// Function that opens the outputs. It is called in a thread of its own. By default, it is
  /// Broadcaster::open().
  using Opener = std::function<Result<std::unique_ptr<broadcast::Broadcaster>>(
      const broadcast::BroadcastInputs&)>;

  explicit OutputController(const Workbench& bench);

  bool isSending() const { return broadcaster_ != nullptr; }
  /// Returns the current state of each output; empty while sending is off.
  std::vector<broadcast::OutletReport> outletReports() const;
  /// Replaces the function that opens outputs.
  void setOpener(Opener opener) { opener_ = std::move(opener); }

Q_SIGNALS:
  /// Emitted when sending has begun or ended, or when the outputs could not be opened.
  void changed();
  /// Emitted when another program requests the start of a take (a recording of all cameras). `name`
  /// describes the take; may be empty.
  void recordingRequested(const QString& name);

private:
  void toggle(bool send);
  void open();
  void startSending(std::shared_ptr<broadcast::Broadcaster> broadcaster);
  void close();
  void receive(const broadcast::RemoteCommand& command);
  void showStatus();
  void updateAction();

  Workbench bench_;
  QAction* action_;
  QLabel* label_;
  QTimer timer_; ///< updates the label
  BackgroundJob* job_;
  Opener opener_ = broadcast::Broadcaster::open;
  std::shared_ptr<broadcast::Broadcaster> broadcaster_; ///< deleted in a thread of its own
  std::shared_future<void> ended_; ///< ready when the last outputs that were opened have ended
  OutputSettings opened_;          ///< settings of the open outputs
  bool wanted_ = false;            ///< the user has switched sending on
};

} // namespace dewpoint::ui
