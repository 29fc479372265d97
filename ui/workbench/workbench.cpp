// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/workbench.h"

#include "ui/actions/action_registry.h"
#include "ui/document/document.h"
#include "ui/workbench/dock_manager.h"

#include <QAction>
#include <QMainWindow>
#include <QWidget>

#include <utility>
#include <vector>

namespace dewpoint::ui {

QAction* Workbench::action(ActionId id) const {
  return actions.action(id);
}

void Workbench::onTriggered(ActionId id, QObject* context, std::function<void()> run) const {
  QObject::connect(action(id), &QAction::triggered, context, std::move(run));
}

void Workbench::onToggled(ActionId id, QObject* context, std::function<void(bool)> run) const {
  QObject::connect(action(id), &QAction::toggled, context, std::move(run));
}

void Workbench::requireRun(std::initializer_list<ActionId> ids) const {
  requireRun(ids, [] { return true; });
}

void Workbench::requireRun(std::initializer_list<ActionId> ids,
                           const std::function<bool()>& suits) const {
  std::vector<QAction*> dependent;
  for (const ActionId id : ids) {
    dependent.push_back(action(id));
  }
  const auto update = [dependent, suits, run = &session, shell = &window] {
    // A page in the center of the window covers the run.
    const QWidget* pages = shell->centralWidget();
    const bool covered = pages != nullptr && !pages->isHidden();
    const bool enabled = run->isRunning() && !covered && suits();
    for (QAction* one : dependent) {
      one->setEnabled(enabled);
    }
  };
  QObject::connect(&session, &SessionController::runStarted, &actions, update);
  QObject::connect(&session, &SessionController::runEnded, &actions, update);
  QObject::connect(&docks, &DockManager::viewsShownChanged, &actions, update);
  QObject::connect(&document, &Document::projectReplaced, &actions, update);
  QObject::connect(&document, &Document::methodChanged, &actions, update);
  update();
}

void Workbench::presentDialog(QWidget* dialog) {
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

} // namespace dewpoint::ui
