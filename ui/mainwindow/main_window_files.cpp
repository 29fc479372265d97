// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/session/session.h"
#include "ui/document/document.h"
#include "ui/document/recovery.h"
#include "ui/mainwindow/main_window.h"
#include "ui/session/session_bridge.h"
#include "ui/start/recent_projects.h"
#include "ui/text/error_sentence.h"
#include "ui/widgets/message_bar.h"

#include <QCloseEvent>
#include <QFileDialog>
#include <QMessageBox>

namespace dewpoint::ui {

namespace {

std::filesystem::path toPath(const QString& file) {
  return file.toStdString();
}

} // namespace

void MainWindow::askOpen() {
  if (!mayDiscard()) {
    return;
  }
  const QString file = QFileDialog::getOpenFileName(
      this, tr("Open a project"), {}, tr("Dewpoint projects (*.toml);;All files (*)"));
  if (!file.isEmpty()) {
    openProject(toPath(file));
  }
}

void MainWindow::save() {
  if (document_->project().file.empty()) {
    askSaveAs();
  } else {
    saveTo(document_->project().file);
  }
}

void MainWindow::askSaveAs() {
  const QString file =
      QFileDialog::getSaveFileName(this, tr("Save the project"), QStringLiteral("project.toml"),
                                   tr("Dewpoint projects (*.toml)"));
  if (!file.isEmpty()) {
    saveTo(toPath(file));
  }
}

void MainWindow::saveTo(std::filesystem::path file) {
  keepLayout();
  if (auto status = document_->saveAs(file); !status) {
    messages_->showError(errorSentence(status.error()));
  } else {
    const QString name = QString::fromStdString(file.string());
    addRecentProject(name);
    messages_->showNotice(tr("Saved %1.").arg(name));
  }
}

bool MainWindow::saveRun(const std::filesystem::path& folder) {
  if (bridge_ == nullptr) {
    return false;
  }
  const auto saved = bridge_->session().saveRun(folder);
  if (!saved) {
    messages_->showError(errorSentence(saved.error()));
  }
  return saved.has_value();
}

bool MainWindow::mayDiscard() {
  // A simulated scene without a file is the demo: what was tried there is not worth a question.
  const Project& project = document_->project();
  if (!document_->isUnsaved() || (project.file.empty() && !project.scene.empty())) {
    return true;
  }
  const auto answer = QMessageBox::question(
      this, tr("Unsaved changes"), tr("Save the changes to this project?"),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save) {
    save();
    return !document_->isUnsaved();
  }
  return answer == QMessageBox::Discard;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (mayDiscard()) {
    if (recovery_ != nullptr) {
      recovery_->forget(); // saved, or given up on purpose
    }
    event->accept();
  } else {
    event->ignore();
  }
}

} // namespace dewpoint::ui
