// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/recovery_offer.h"

#include "ui/text/error_sentence.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/dock_manager.h"

#include <QMainWindow>

#include <utility>

namespace dewpoint::ui {

namespace {
/// How often is looked for work of a window that was still there before. Chosen: a person waits no
/// longer for it.
constexpr std::chrono::seconds kLookAgain(8);
} // namespace

RecoveryOffer::RecoveryOffer(const Workbench& bench, const std::filesystem::path& folder,
                             TextWriter write)
    : QObject(&bench.window), bench_(bench),
      recovery_(new Recovery(bench.document, folder, this, std::move(write))) {
  connect(recovery_, &Recovery::failed, &bench_.messages, &MessageBar::showError);
  connect(recovery_, &Recovery::backupStarting, &bench_.docks, &DockManager::storeLayout);
  offerRecovery();
  // A window that was killed may take a while to be gone, and one that is alive may be killed
  // later.
  connect(&searchTimer_, &QTimer::timeout, this, [this] {
    if (!searching_) { // else the disk is slow
      offerRecovery();
    }
  });
  searchTimer_.start(kLookAgain);
}

void RecoveryOffer::offerRecovery() {
  searching_ = true;
  recovery_->findBackups([this](const std::vector<RecoverableWork>& left) {
    searching_ = false;
    ask(left);
    Q_EMIT searchEnded();
  });
}

void RecoveryOffer::ask(const std::vector<RecoverableWork>& left) {
  if (left.empty()) {
    return;
  }
  searchTimer_.stop();
  const RecoverableWork& work = left.front();
  // Meanwhile a project may be opened, and much be said: the question comes back after that.
  bench_.messages.showLastingQuestion(
      tr("Dewpoint closed unexpectedly. Unsaved changes to “%1” from %2 can be recovered.")
          .arg(work.projectName, work.backupTimeText),
      {{tr("Recover"), [this, work] { Q_EMIT recoveryRequested(work); }},
       {tr("Discard"), [this, work] { discardWork(work); }}});
}

void RecoveryOffer::discardWork(const RecoverableWork& work) {
  recovery_->discard(work);
  recovery_->findBackups([this, work](const std::vector<RecoverableWork>& left) {
    ask(left); // of other work, once this is read
    bench_.messages.showQuestion(
        tr("Unsaved changes to “%1” were discarded.").arg(work.projectName),
        {{tr("Undo"), [this, work] {
            recovery_->undoDiscard(work);
            offerRecovery();
          }}});
  });
}

void RecoveryOffer::recover(const RecoverableWork& work) {
  recovery_->recover(work, [this, work](const Result<Project>& project) {
    if (project) {
      Q_EMIT recovered(*project, work);
    } else {
      bench_.messages.showError(errorText(project.error()));
    }
  });
}

} // namespace dewpoint::ui
