// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_installer.h"

#include "core/session/session.h"
#include "ui/document/document.h"
#include "ui/document/method_presentation.h"
#include "ui/export/box_export_dialog.h"
#include "ui/export/export_destination.h"
#include "ui/export/export_dialog.h"
#include "ui/selection/selection.h"
#include "ui/session/result_refresher.h"
#include "ui/timeline/timeline.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/workbench.h"

#include <QMainWindow>

#include <utility>

namespace dewpoint::ui {

namespace {

/// Tells in the window how exports went whose dialog was closed; one that is shown says it itself.
void connectMessages(const Workbench& bench, ExportDialog* dialog) {
  MessageBar* messages = &bench.messages;
  QObject::connect(dialog, &ExportDialog::completed, messages,
                   [dialog, messages](const QString& text) {
                     if (!dialog->isVisible()) {
                       messages->showNotice(text);
                     }
                   });
  QObject::connect(dialog, &ExportDialog::failed, messages,
                   [dialog, messages](const QString& text) {
                     if (!dialog->isVisible()) {
                       messages->showError(text);
                     }
                   });
}

void connectMessages(const Workbench& bench, BoxExportDialog* dialog) {
  QObject::connect(dialog, &BoxExportDialog::completed, &bench.messages, &MessageBar::showNotice);
  QObject::connect(dialog, &BoxExportDialog::failed, &bench.messages, &MessageBar::showError);
}

QString trajectoryFile(const ExportDestination& destination) {
  return destination.proposedFile(QStringLiteral("trajectory"));
}

void exportBoxes(const Workbench& bench) {
  ExportDestination* destination = ExportDestination::forWorkbench(bench);
  auto* dialog = bench.window.findChild<BoxExportDialog*>();
  if (dialog == nullptr) {
    const auto boxes = [run = &bench.session] {
      return run->isRunning() ? run->session()->boxTrack() : BoxTrack();
    };
    dialog = new BoxExportDialog(boxes, &bench.window);
    connectMessages(bench, dialog);
    const auto reset = [dialog, destination] { dialog->resetFolder(destination->folder()); };
    QObject::connect(&bench.document, &Document::projectReplaced, dialog, reset);
    QObject::connect(dialog, &BoxExportDialog::fileWritten, destination,
                     &ExportDestination::rememberFolder);
    reset();
  }
  dialog->proposeFolder(destination->folder());
  Workbench::presentDialog(dialog);
}

void exportTrajectory(const Workbench& bench, const TimelineModel& time) {
  ExportDestination* destination = ExportDestination::forWorkbench(bench);
  auto* dialog = bench.window.findChild<ExportDialog*>();
  if (dialog == nullptr) {
    const auto trajectory = [run = &bench.session] {
      return run->isRunning() ? run->session()->trajectory() : Trajectory();
    };
    dialog = new ExportDialog(trajectory, &bench.window);
    connectMessages(bench, dialog);
    const auto resetChoices = [dialog, destination] {
      dialog->resetChoices(trajectoryFile(*destination));
    };
    QObject::connect(&bench.document, &Document::projectReplaced, dialog, resetChoices);
    QObject::connect(dialog, &ExportDialog::fileWritten, destination,
                     &ExportDestination::rememberFolder);
    resetChoices();
    const auto sayOld = [dialog, results = &bench.session.resultRefresher()] {
      dialog->setResultsOutdated(!results->oldResults().frameRanges.empty());
    };
    QObject::connect(&bench.session.resultRefresher(), &ResultRefresher::oldResultsChanged, dialog,
                     sayOld);
    sayOld();
  }
  dialog->proposeFile(trajectoryFile(*destination));
  const auto& selectedRange = bench.selection.selectedRange();
  dialog->setSelectedRange(selectedRange
                               ? std::optional(std::pair(time.secondsOf(selectedRange->first),
                                                         time.secondsOf(selectedRange->last)))
                               : std::nullopt);
  Workbench::presentDialog(dialog);
}

} // namespace

void installExport(const Workbench& bench, const Timeline& timeline) {
  bench.onTriggered("actionExportTrajectory", &bench.window, [bench, &timeline] {
    if (bench.document.methodPresentation().resultsAreBoxes) {
      exportBoxes(bench);
    } else {
      exportTrajectory(bench, timeline.model());
    }
  });
  bench.requireRun({"actionExportTrajectory"});
}

} // namespace dewpoint::ui
