// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/timeline_dock.h"

#include "core/project/project.h"
#include "core/session/session.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/session/logged_records.h"
#include "ui/session/result_refresher.h"
#include "ui/timeline/frame_field.h"
#include "ui/timeline/timeline.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/dock_manager.h"
#include "ui/workbench/workbench.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>

namespace dewpoint::ui {

namespace {

void showMenu(const Workbench& bench, const QPoint& place) {
  auto* menu = new QMenu(&bench.window);
  menu->setObjectName(QStringLiteral("menuTimeline"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (const ActionId id : std::initializer_list<ActionId>{
           "actionRerun", "actionTrackAgain", "actionNow", nullptr, "actionAddMark",
           "actionRemoveMark", "actionPreviousMark", "actionNextMark", nullptr, "actionGoToFrame",
           "actionPreviousTrouble", "actionNextTrouble", nullptr, "actionCorrectPosition",
           "actionRemoveCorrection", nullptr, "actionZoomToSpan"}) {
    id.isSeparator() ? (void)menu->addSeparator() : menu->addAction(bench.action(id));
  }
  menu->popup(place);
}

void openFrameField(const Workbench& bench, ViewDock* dock, Timeline* timeline, FrameField* field) {
  if (bench.docks.maximizedDock() != nullptr && bench.docks.maximizedDock() != dock) {
    bench.docks.restoreMaximized();
  }
  if (dock->isBehindOtherDocks()) {
    dock->bringToFront();
  }
  field->open(timeline->latestFrame());
}

void stepToProblem(const Workbench& bench, Timeline* timeline, int direction) {
  if (!timeline->stepToProblem(direction)) {
    bench.messages.showNotice(
        direction > 0
            ? Timeline::tr("After this frame, there are no new problems with targets or cameras.")
            : Timeline::tr(
                  "Before this frame, there are no other problems with targets or cameras."));
  }
}

void connectActions(const Workbench& bench, ViewDock* dock, Timeline* timeline) {
  auto* field = new FrameField(*timeline);
  bench.onTriggered("actionGoToFrame", field, [bench, dock, timeline, field] {
    openFrameField(bench, dock, timeline, field);
  });
  bench.onTriggered("actionPreviousTrouble", timeline,
                    [bench, timeline] { stepToProblem(bench, timeline, -1); });
  bench.onTriggered("actionNextTrouble", timeline,
                    [bench, timeline] { stepToProblem(bench, timeline, 1); });
  bench.onTriggered("actionPreviousFrame", timeline, [timeline] { timeline->step(-1); });
  bench.onTriggered("actionNow", timeline, [bench] { bench.selection.requestLiveFrame(); });
  bench.onTriggered("actionRerun", timeline, [bench] { bench.session.rerun(); });
  bench.onTriggered("actionAddMark", timeline, [timeline] { timeline->addMarker(); });
  bench.onTriggered("actionRemoveMark", timeline, [timeline] { timeline->removeMarker(); });
  bench.onTriggered("actionPreviousMark", timeline, [timeline] { timeline->stepToMarker(-1); });
  bench.onTriggered("actionNextMark", timeline, [timeline] { timeline->stepToMarker(1); });
  bench.onTriggered("actionZoomToSpan", timeline, [timeline] { timeline->zoomToRange(); });
  bench.requireRun({"actionPreviousFrame", "actionRerun", "actionAddMark", "actionRemoveMark",
                    "actionPreviousMark", "actionNextMark", "actionGoToFrame",
                    "actionPreviousTrouble", "actionNextTrouble", "actionZoomToSpan"});
  bench.action("actionNow")->setEnabled(false); // the current frame decides
}

/// Whoever changes something while looking back at live cameras is told what that changes; of a
/// recording what is shown follows the change (ResultRefresher).
void explainChange(const Workbench& bench, const ProjectChanges& changes) {
  const bool again = changes.boxesChanged && bench.document.methodFamily().retracksAfterEdit;
  const bool isLive = bench.session.shownSnapshot() && !bench.session.shownSnapshot()->frameCount;
  if (isLive && bench.selection.isAwayFromLiveFrame() &&
      (changes.parametersChanged || changes.targetsChanged) && !again) {
    bench.messages.showNotice(
        Timeline::tr(
            "The change applies to new frames. Use “%1” to track again from the current frame.")
            .arg(bench.action("actionRerun")->text()));
  }
}

} // namespace

Timeline* installTimeline(const Workbench& bench) {
  auto* timeline = new Timeline(bench.selection, bench.document, &bench.window);
  ViewDock* dock = bench.docks.makeDock({.name = QStringLiteral("timelineDock"),
                                         .title = [] { return Timeline::tr("Timeline"); },
                                         .content = timeline,
                                         .area = DockArea::Timeline});
  QObject::connect(&bench.session, &SessionController::framesLogged, timeline,
                   [timeline](const LoggedFrames& frames) {
                     timeline->append(frames.records, frames.restarted);
                   });
  bench.connectView(timeline);
  QObject::connect(&bench.session.resultRefresher(), &ResultRefresher::oldResultsChanged, timeline,
                   [timeline, results = &bench.session.resultRefresher()] {
                     timeline->setOldResults(results->oldResults().frameRanges);
                   });
  QObject::connect(&bench.session, &SessionController::snapshotChanged, timeline,
                   [bench, timeline](const TrackSnapshotPtr& snapshot) {
                     bench.action("actionNow")->setEnabled(snapshot && snapshot->isPast);
                     if (snapshot) {
                       bench.selection.setCurrentFrame(snapshot->frame,
                                                       timeline->model().secondsOf(snapshot->frame),
                                                       snapshot->isPast);
                     }
                   });
  QObject::connect(timeline, &Timeline::menuRequested, timeline,
                   [bench](const QPoint& place) { showMenu(bench, place); });
  QObject::connect(&bench.document, &Document::changed, timeline,
                   [bench](const ProjectChanges& changes) { explainChange(bench, changes); });
  connectActions(bench, dock, timeline);
  return timeline;
}

} // namespace dewpoint::ui
