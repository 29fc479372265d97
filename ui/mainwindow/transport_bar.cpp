// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/transport_bar.h"

#include "ui/mainwindow/speed_button.h"
#include "ui/text/retranslation.h"
#include "ui/workbench/workbench.h"

#include <QAction>
#include <QCoreApplication>
#include <QMainWindow>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>

namespace dewpoint::ui {

namespace {

class TransportBar : public QToolBar {
  Q_DECLARE_TR_FUNCTIONS(TransportBar)
public:
  explicit TransportBar(const Workbench& bench);

private:
  void add(QAction* action);
  void placeRecord(const Workbench& bench);
};

TransportBar::TransportBar(const Workbench& bench) {
  onRetranslate(this, [this] { setWindowTitle(tr("Toolbar")); });
  setObjectName(QStringLiteral("transportBar"));
  setMovable(false);
  setIconSize({20, 20});
  setContextMenuPolicy(Qt::PreventContextMenu);
  // The run first, then what teaches it, then the project.
  for (const ActionId id : std::initializer_list<ActionId>{
           "actionRestart", "actionPreviousFrame", "actionPlay", "actionNextFrame",
           "actionNextIteration", nullptr, "actionLearnColor", "actionAddTarget", "actionShowMask",
           nullptr, "actionUndo", "actionRedo", nullptr, "actionOpen", "actionSave",
           "actionExportTrajectory", nullptr, "actionPalette"}) {
    id.isSeparator() ? (void)addSeparator() : add(bench.action(id));
  }
  for (const ActionId id : std::initializer_list<ActionId>{
           "actionPlay", "actionNextFrame", "actionNextIteration", "actionLearnColor",
           "actionAddTarget", "actionExportTrajectory"}) {
    static_cast<QToolButton*>(widgetForAction(bench.action(id)))
        ->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
  placeRecord(bench);
  const qsizetype place = actions().indexOf(bench.action("actionPlay"));
  insertWidget(actions().at(place + 1), new SpeedButton(bench));
  onRetranslate(this, [this, play = bench.action("actionPlay"),
                       exporting = bench.action("actionExportTrajectory")] {
    exporting->setIconText(tr("Export"));
    const int widest = std::max(fontMetrics().horizontalAdvance(tr("Play")),
                                fontMetrics().horizontalAdvance(tr("Pause")));
    widgetForAction(play)->setMinimumWidth(widest + 44); // the others stay where they are
  });
}

/// The button is there only for live cameras: recordings need the room for other buttons.
void TransportBar::placeRecord(const Workbench& bench) {
  QAction* record = bench.action("actionRecord");
  connect(&bench.session, &SessionController::runStarted, this, [this, record, bench] {
    if (bench.session.encodedFeeds().empty()) {
      removeAction(record);
    } else if (!actions().contains(record)) {
      insertAction(bench.action("actionLearnColor"), record);
      QWidget* button = widgetForAction(record);
      button->setObjectName(QStringLiteral("actionRecordButton"));
      button->setFocusPolicy(Qt::NoFocus);
      static_cast<QToolButton*>(button)->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    }
  });
}

void TransportBar::add(QAction* action) {
  addAction(action);
  QWidget* button = widgetForAction(action);
  button->setObjectName(action->objectName() + QStringLiteral("Button"));
  button->setFocusPolicy(Qt::NoFocus); // Space stays with play
}

} // namespace

void installTransportBar(const Workbench& bench) {
  bench.window.addToolBar(new TransportBar(bench));
}

} // namespace dewpoint::ui
