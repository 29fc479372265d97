// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/recovery.h"
#include "ui/workbench/workbench.h"

#include <QTimer>

#include <chrono>
#include <filesystem>
#include <vector>

namespace dewpoint::ui {

/// Offers the unsaved work that an earlier window left behind, one after the other, and keeps that
/// of this one.
class RecoveryOffer : public QObject {
  Q_OBJECT
public:
  RecoveryOffer(const Workbench& bench, const std::filesystem::path& folder, TextWriter write);

  /// Asks about the newest work that was left behind, if there is any.
  void offer();
  /// How often is looked again until some was found.
  void setInterval(std::chrono::milliseconds interval) { lookAgain_.setInterval(interval); }
  /// The document is this work now.
  void take(const RecoverableWork& work) { recovery_->take(work); }
  /// The work of this window is saved or given up on purpose.
  void removeBackup() { recovery_->removeBackup(); }
  /// Reads the work: recovered() follows, or an error in the window.
  void recover(const RecoverableWork& work);

Q_SIGNALS:
  /// Work was searched for, and a question was shown about what was found.
  void looked();
  /// The user wants it: recover() it, or offer() it again later.
  void wanted(const RecoverableWork& work);
  /// It is read, and to be opened.
  void recovered(const Project& project, const RecoverableWork& work);

private:
  void ask(const std::vector<RecoverableWork>& left);
  void throwAway(const RecoverableWork& work);

  Workbench bench_;
  Recovery* recovery_;
  QTimer lookAgain_; ///< until some work was offered
  bool looking_ = false;
};

} // namespace dewpoint::ui
