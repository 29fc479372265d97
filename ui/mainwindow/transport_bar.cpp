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

namespace dewpoint::ui {

namespace {

class TransportBar : public QToolBar {
  Q_DECLARE_TR_FUNCTIONS(TransportBar)
public:
  explicit TransportBar(const Workbench& bench);

private:
  void add(QAction* action);
};

TransportBar::TransportBar(const Workbench& bench) {
  onRetranslate(this, [this] { setWindowTitle(tr("Transport")); });
  setObjectName(QStringLiteral("transportBar"));
  setMovable(false);
  setIconSize({20, 20});
  setContextMenuPolicy(Qt::PreventContextMenu);
  for (const ActionId id :
       std::initializer_list<ActionId>{"actionPlay",      "actionPreviousFrame",
                                       "actionNextFrame", "actionNextIteration",
                                       nullptr,           "actionNow",
                                       "actionRerun",     nullptr,
                                       "actionRestart",   "actionRestartNewSeed",
                                       nullptr,           "actionLearnColor",
                                       "actionShowMask",  nullptr,
                                       "actionUndo",      "actionRedo",
                                       nullptr,           "actionOpen",
                                       "actionSave",      "actionExportTrajectory",
                                       nullptr,           "actionPalette"}) {
    id.isSeparator() ? (void)addSeparator() : add(bench.action(id));
  }
  for (const ActionId id :
       std::initializer_list<ActionId>{"actionPlay", "actionNextFrame", "actionNextIteration"}) {
    static_cast<QToolButton*>(widgetForAction(bench.action(id)))
        ->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
  insertWidget(actions().at(1), new SpeedButton(bench)); // beside Play
  widgetForAction(bench.action("actionPlay"))
      ->setMinimumWidth(fontMetrics().horizontalAdvance(tr("Pause")) + 40);
}

void TransportBar::add(QAction* action) {
  addAction(action);
  QWidget* button = widgetForAction(action);
  button->setObjectName(action->objectName() + QStringLiteral("Button"));
  button->setFocusPolicy(Qt::NoFocus); // Space stays with play
}

} // namespace

QToolBar* installTransportBar(const Workbench& bench) {
  auto* bar = new TransportBar(bench);
  bench.window.addToolBar(bar);
  return bar;
}

} // namespace dewpoint::ui
