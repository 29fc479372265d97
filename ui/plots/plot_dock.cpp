// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_dock.h"

#include "core/session/session.h"
#include "ui/document/document.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_stack.h"
#include "ui/session/logged_records.h"
#include "ui/widgets/dock_title.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/dock_manager.h"
#include "ui/workbench/workbench.h"

#include <QMainWindow>

namespace dewpoint::ui {

PlotPanel* installPlots(const Workbench& bench) {
  auto* panel = new PlotPanel(bench.actions, bench.selection, &bench.window);
  ViewDock* dock = bench.docks.makeDock({.name = QStringLiteral("plotDock"),
                                         .title = [] { return PlotPanel::tr("Plots"); },
                                         .content = panel,
                                         .area = DockArea::Plots,
                                         .orderInArea = 0});
  dock->title().addTool(panel->makeTitleTools(&dock->title()));
  bench.connectView(panel);
  QObject::connect(&bench.session, &SessionController::iterationsLogged, panel,
                   [panel](const LoggedIterations& iterations) {
                     if (iterations.restarted) {
                       panel->clear();
                     }
                     panel->append(iterations.records);
                   });
  QObject::connect(&bench.document, &Document::projectReplaced, &panel->stack(),
                   &PlotStack::showWholeRun);
  QObject::connect(&bench.session, &SessionController::runAboutToRestart, &panel->stack(),
                   &PlotStack::showWholeRun);
  QObject::connect(panel, &PlotPanel::noticeRequested, &bench.messages, &MessageBar::showNotice);
  QObject::connect(panel, &PlotPanel::failed, &bench.messages, &MessageBar::showError);
  return panel;
}

} // namespace dewpoint::ui
