// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trajectory/trajectory_dock.h"

#include "core/session/session.h"
#include "ui/document/document.h"
#include "ui/plots/plot_stack.h"
#include "ui/trajectory/box_panel.h"
#include "ui/trajectory/trajectory_panel.h"
#include "ui/view3d/birds_eye_view.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/dock_manager.h"
#include "ui/workbench/workbench.h"

#include <QMainWindow>

namespace dewpoint::ui {

TrajectoryPanel* installTrajectory(const Workbench& bench, BirdsEyeView& birdsEye) {
  auto* panel = new TrajectoryPanel(bench.actions, bench.selection, &bench.window);
  bench.docks.makeDock({.name = QStringLiteral("trajectoryDock"),
                        .title = [] { return TrajectoryPanel::tr("Trajectory"); },
                        .content = panel,
                        .area = DockArea::Plots,
                        .orderInArea = 1});
  const SessionController& run = bench.session;
  QObject::connect(&run, &SessionController::runStarted, panel, [panel, &run] {
    const Session* session = run.session();
    panel->setSource([session](auto& generation, auto& position) {
      return session->samplesSince(generation, position);
    });
    panel->boxPanel().setSource([session](auto& generation, auto& position) {
      return session->boxesSince(generation, position);
    });
  });
  QObject::connect(&run, &SessionController::runEnded, panel, [panel] {
    panel->setSource({});
    panel->boxPanel().setSource({});
  });
  bench.connectView(panel);
  QObject::connect(&run, &SessionController::iterationsLogged, panel, &TrajectoryPanel::refresh);
  QObject::connect(&bench.document, &Document::projectReplaced, &panel->plots(),
                   &PlotStack::showWholeRun);
  QObject::connect(&run, &SessionController::runAboutToRestart, &panel->plots(),
                   &PlotStack::showWholeRun);
  QObject::connect(panel, &TrajectoryPanel::noticeRequested, &bench.messages,
                   &MessageBar::showNotice);
  QObject::connect(panel, &TrajectoryPanel::highlightChanged, &birdsEye, &BirdsEyeView::highlight);
  QObject::connect(&birdsEye, &BirdsEyeView::tailClicked, panel, &TrajectoryPanel::choosePosition);
  return panel;
}

} // namespace dewpoint::ui
