// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/recovery.h"
#include "ui/workbench/workbench.h"

#include <QTimer>

#include <chrono>
#include <filesystem>
#include <vector>

namespace dewpoint::ui {

/// Offers unsaved work left by earlier windows, one copy at a time, and keeps copies of this
/// window's work.
class RecoveryOffer : public QObject {
  Q_OBJECT
public:
  RecoveryOffer(const Workbench& bench, const std::filesystem::path& folder, TextWriter write);

  /// Asks the user whether to recover the newest copy of unsaved work, if there is one.
  void offerRecovery();
  /// Sets how often the folder with the copies of unsaved work is searched until a copy is found.
  void setSearchInterval(std::chrono::milliseconds interval) { searchTimer_.setInterval(interval); }
  /// Notes that the document now contains this recovered work.
  void adoptBackup(const RecoverableWork& work) { recovery_->adoptBackup(work); }
  /// Removes the copy of this window's work. Call this when the work was saved or discarded.
  void removeBackup() { recovery_->removeBackup(); }
  /// Reads a copy of unsaved work. Emits `recovered()` with the project afterwards, or shows an
  /// error in the window.
  void recover(const RecoverableWork& work);

Q_SIGNALS:
  /// Emitted after the folder was searched for copies of unsaved work. If there is one, a question
  /// about it is now shown.
  void searchEnded();
  /// Emitted when the user wants to recover this unsaved work. The receiver calls `recover()`, or
  /// calls `offerRecovery()` later to ask again.
  void recoveryRequested(const RecoverableWork& work);
  /// Emitted when the work was read and can be opened.
  void recovered(const Project& project, const RecoverableWork& work);

private:
  void ask(const std::vector<RecoverableWork>& left);
  void discardWork(const RecoverableWork& work);

  Workbench bench_;
  Recovery* recovery_;
  QTimer searchTimer_; ///< runs until work was offered
  bool searching_ = false;
};

} // namespace dewpoint::ui
