// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/history_dock.h"

#include "ui/document/document.h"
#include "ui/text/retranslation.h"
#include "ui/workbench/dock_manager.h"

#include <QAction>
#include <QMainWindow>
#include <QUndoStack>
#include <QUndoView>

namespace dewpoint::ui {

HistoryDock::HistoryDock(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
  QUndoStack* history = bench_.document.undoStack();
  auto* view = new QUndoView(history, &bench_.window);
  view->setObjectName(QStringLiteral("historyList"));
  view->setFrameShape(QFrame::NoFrame);
  onRetranslate(view, [view] {
    view->setEmptyLabel(tr("Initial state"));
    view->setAccessibleName(tr("History of changes"));
  });
  bench_.docks.makeDock({.name = QStringLiteral("historyDock"),
                         .title = [] { return tr("History"); },
                         .content = view,
                         .area = DockArea::History,
                         .isHiddenAtFirst = true});
  // As QUndoStack::createUndoAction() does, whose texts stay in the language they were made in.
  QAction* undo = bench_.action("actionUndo");
  QAction* redo = bench_.action("actionRedo");
  connect(undo, &QAction::triggered, history, &QUndoStack::undo);
  connect(redo, &QAction::triggered, history, &QUndoStack::redo);
  connect(history, &QUndoStack::canUndoChanged, undo, &QAction::setEnabled);
  connect(history, &QUndoStack::canRedoChanged, redo, &QAction::setEnabled);
  connect(history, &QUndoStack::undoTextChanged, this, &HistoryDock::updateActionTexts);
  connect(history, &QUndoStack::redoTextChanged, this, &HistoryDock::updateActionTexts);
  undo->setEnabled(history->canUndo());
  redo->setEnabled(history->canRedo());
  updateActionTexts();
}

void HistoryDock::updateActionTexts() {
  const QUndoStack& history = *bench_.document.undoStack();
  QAction* undo = bench_.action("actionUndo");
  QAction* redo = bench_.action("actionRedo");
  undo->setText(history.canUndo() ? tr("Undo: %1").arg(history.undoText()) : tr("Undo"));
  redo->setText(history.canRedo() ? tr("Redo: %1").arg(history.redoText()) : tr("Redo"));
}

} // namespace dewpoint::ui
