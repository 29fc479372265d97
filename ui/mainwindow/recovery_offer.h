// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/recovery.h"
#include "ui/workbench/workbench.h"

#include <QTimer>

#include <chrono>
#include <filesystem>
#include <vector>

namespace dewpoint::ui {

/// Offers unsaved work that earlier windows left behind, one copy at a time, and keeps copies of
/// the work of this window.
class RecoveryOffer : public QObject {
  Q_OBJECT
public:
  RecoveryOffer(const Workbench& bench, const std::filesystem::path& folder, TextWriter write);

  /// Asks about the newest work left behind, if there is any.
  void offer();
  /// Sets how often the folder is searched until work is found.
  void setInterval(std::chrono::milliseconds interval) { lookAgain_.setInterval(interval); }
  /// Reports that the document now contains this work.
  void take(const RecoverableWork& work) { recovery_->take(work); }
  /// Removes the copy, because the work of this window was saved or discarded.
  void removeBackup() { recovery_->removeBackup(); }
  /// Reads the work; `recovered()` follows, or an error in the window.
  void recover(const RecoverableWork& work);

Q_SIGNALS:
  /// The folder was searched, and a question is shown if work was found.
  void looked();
  /// The user wants to recover it: call `recover()`, or `offer()` it again later.
  void wanted(const RecoverableWork& work);
  /// The work was read and can be opened.
  void recovered(const Project& project, const RecoverableWork& work);

private:
  void ask(const std::vector<RecoverableWork>& left);
  void throwAway(const RecoverableWork& work);

  Workbench bench_;
  Recovery* recovery_;
  QTimer lookAgain_; ///< runs until some work was offered
  bool looking_ = false;
};

} // namespace dewpoint::ui
