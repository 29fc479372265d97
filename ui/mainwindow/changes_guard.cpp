// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/changes_guard.h"

#include "core/project/project.h"
#include "core/setup/new_project/new_project.h"
#include "ui/document/document.h"
#include "ui/document/project_saver.h"
#include "ui/mainwindow/project_endings.h"
#include "ui/widgets/file_choice.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/dock_manager.h"

#include <QMainWindow>
#include <QMessageBox>

#include <utility>

namespace dewpoint::ui {

ChangesGuard::ChangesGuard(const Workbench& bench, QObject* parent)
    : QObject(parent), bench_(bench), saver_(new ProjectSaver(bench.document, this)) {
  bench_.onTriggered("actionSave", this, [this] { save(); });
  bench_.onTriggered("actionSaveAs", this, [this] { askSaveAs(); });
  bench_.requireRun({"actionSave", "actionSaveAs"});
  connectSaver();
}

void ChangesGuard::save() {
  if (bench_.document.project().file.empty()) {
    askSaveAs();
  } else {
    saveTo(bench_.document.project().file);
  }
}

void ChangesGuard::askSaveAs() {
  const Project& project = bench_.document.project();
  const auto proposed = project.file.empty() ? proposedProjectFile(project) : project.file;
  const QString file = askForFileToSave(&bench_.window, tr("Save the project"),
                                        QString::fromStdString(proposed.string()),
                                        withAllProjectSuffixes(tr("Dewpoint projects (*.toml)")));
  if (!file.isEmpty()) {
    saveTo(file.toStdString());
  }
}

// NOLINTNEXTLINE(performance-unnecessary-value-param): storing the layout replaces the project
void ChangesGuard::saveTo(std::filesystem::path file) {
  bench_.docks.storeLayout();
  saver_->save(file);
}

void ChangesGuard::connectSaver() {
  connect(saver_, &ProjectSaver::saved, this, [this](const QString& file) {
    Q_EMIT saved(file);
    bench_.messages.showNotice(tr("Saved %1.").arg(file));
    if (const auto next = std::exchange(afterSaving_, {})) {
      runAfterSaveOrDiscard(next); // it may have been changed while it was saved
    }
  });
  connect(saver_, &ProjectSaver::failed, this, [this](const QString& sentence) {
    afterSaving_ = {};
    bench_.messages.showError(sentence);
  });
}

bool ChangesGuard::confirmDiscard(const std::function<void()>& then) {
  // A simulated scene without a file is the demo: what was tried there is not worth a question.
  const Project& project = bench_.document.project();
  if (!bench_.document.isUnsaved() || (project.file.empty() && !project.scene.empty())) {
    return true;
  }
  const auto answer = QMessageBox::question(
      &bench_.window, tr("Unsaved changes"), tr("Save the changes to this project?"),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save) {
    save();
    afterSaving_ = saver_->isSaving() ? then : std::function<void()>();
  }
  return answer == QMessageBox::Discard;
}

void ChangesGuard::runAfterSaveOrDiscard(const std::function<void()>& next) {
  if (confirmDiscard(next)) {
    next();
  }
}

} // namespace dewpoint::ui
