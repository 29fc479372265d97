// SPDX-License-Identifier: GPL-3.0-or-later
// What leaves the window: the trajectory, and pictures of views.
#include "core/project/project.h"
#include "core/session/session.h"
#include "ui/document/document.h"
#include "ui/experiments/experiment_dialog.h"
#include "ui/export/box_export_dialog.h"
#include "ui/export/export_dialog.h"
#include "ui/export/view_picture.h"
#include "ui/mainwindow/main_window.h"
#include "ui/selection/selection.h"
#include "ui/session/session_bridge.h"
#include "ui/text/error_sentence.h"
#include "ui/timeline/timeline.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QMenu>

namespace dewpoint::ui {

void MainWindow::exportBoxes() {
  auto* dialog = findChild<BoxExportDialog*>();
  if (dialog == nullptr) {
    dialog = new BoxExportDialog(
        [this] { return bridge_ == nullptr ? BoxTrack() : bridge_->session().boxTrack(); }, this);
    connect(dialog, &BoxExportDialog::done, messages_, &MessageBar::showNotice);
    connect(dialog, &BoxExportDialog::failed, messages_, &MessageBar::showError);
    const auto propose = [this, dialog] {
      const auto project = document_->project().file;
      dialog->proposeIn(project.empty() ? QDir::homePath()
                                        : QString::fromStdString(project.parent_path().string()));
    };
    connect(document_, &Document::replaced, dialog, propose);
    propose();
  }
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

void MainWindow::exportTrajectory() {
  if (followsBoxes()) {
    exportBoxes();
    return;
  }
  auto* dialog = findChild<ExportDialog*>();
  if (dialog == nullptr) {
    const auto run = [this] {
      return bridge_ == nullptr ? Trajectory() : bridge_->session().trajectory();
    };
    dialog = new ExportDialog(run, this);
    connect(dialog, &ExportDialog::done, messages_, &MessageBar::showNotice);
    connect(dialog, &ExportDialog::failed, messages_, &MessageBar::showError);
    const auto startAnew = [this, dialog] {
      const auto project = document_->project().file;
      dialog->startAnew(project.empty() ? QDir::homePath()
                                        : QString::fromStdString(project.parent_path().string()));
    };
    connect(document_, &Document::replaced, dialog, startAnew);
    startAnew();
  }
  const auto& span = selection_->span();
  const TimelineModel& time = timeline_->model();
  dialog->setSpan(
      span ? std::optional(std::pair(time.secondsOf(span->first), time.secondsOf(span->last)))
           : std::nullopt);
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

void MainWindow::openExperiments() {
  auto* dialog = findChild<ExperimentDialog*>();
  if (dialog == nullptr) {
    dialog = new ExperimentDialog(this);
    connect(dialog, &ExperimentDialog::failed, messages_, &MessageBar::showError);
  }
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

void MainWindow::addPictureMenu(QDockWidget* dock, QWidget* bar) {
  // On the title: a right click into the view itself belongs to the view.
  bar->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(bar, &QWidget::customContextMenuRequested, this, [this, dock, bar](QPoint place) {
    QMenu menu;
    menu.setObjectName(QStringLiteral("menuPicture"));
    connect(menu.addAction(tr("Save picture as PNG…")), &QAction::triggered, this,
            [this, dock] { savePictureOf(dock); });
    connect(menu.addAction(tr("Copy picture")), &QAction::triggered, this,
            [dock] { QApplication::clipboard()->setImage(pictureOf(dock->widget())); });
    menu.exec(bar->mapToGlobal(place));
  });
}

void MainWindow::choosePicture() {
  QMenu menu;
  menu.setObjectName(QStringLiteral("menuPictures"));
  for (QDockWidget* dock : findChildren<QDockWidget*>()) {
    if (dock->isVisible() && !dock->visibleRegion().isEmpty()) {
      connect(menu.addAction(dock->windowTitle()), &QAction::triggered, this,
              [this, dock] { savePictureOf(dock); });
    }
  }
  menu.exec(mapToGlobal(rect().center()));
}

void MainWindow::savePictureOf(QDockWidget* dock) {
  const QImage picture = pictureOf(dock->widget()); // as it is now, not after the question
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save a picture of %1").arg(dock->windowTitle()),
      QDir::home().filePath(dock->windowTitle() + QStringLiteral(".png")), tr("Pictures (*.png)"));
  if (file.isEmpty()) {
    return;
  }
  const Status written = writePicture(picture, file.toStdString());
  if (written) {
    messages_->showNotice(tr("Saved the picture %1.").arg(file));
  } else {
    messages_->showError(errorSentence(written.error()));
  }
}

} // namespace dewpoint::ui
