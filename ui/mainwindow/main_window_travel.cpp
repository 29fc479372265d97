// SPDX-License-Identifier: GPL-3.0-or-later
// Going through time: timeline, moments, marks, tracking again.
#include "core/session/session.h"
#include "ui/actions/action_registry.h"
#include "ui/cameraview/camera_view.h"
#include "ui/document/document.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/status_bar_panel.h"
#include "ui/selection/selection.h"
#include "ui/session/session_bridge.h"
#include "ui/text/camera_motion_text.h"
#include "ui/text/reason_text.h"
#include "ui/timeline/timeline.h"
#include "ui/widgets/dock_title.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>

namespace dewpoint::ui {

void MainWindow::makeTimeline() {
  timeline_ = new Timeline(*selection_, *document_, this);
  timelineDock_ = makeDock(
      QStringLiteral("timelineDock"), [] { return tr("Timeline"); }, timeline_);
  connect(selection_, &Selection::momentWanted, this, [this](qint64 frame) {
    if (bridge_ != nullptr) {
      bridge_->session().showFrame(frame);
    }
  });
  connect(selection_, &Selection::nowWanted, this, [this] {
    if (bridge_ != nullptr) {
      bridge_->session().backToHead();
    }
  });
  connect(timeline_, &Timeline::menuWanted, this, [this](const QPoint& place) {
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("menuTimeline"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const char* id : {"actionRerun", "actionNow", "", "actionAddMark", "actionRemoveMark",
                           "actionPreviousMark", "actionNextMark", "", "actionZoomToSpan"}) {
      *id == '\0' ? (void)menu->addSeparator() : menu->addAction(action(id));
    }
    menu->popup(place);
  });
}

void MainWindow::connectTravel() {
  const auto on = [this](const char* id, auto&& run) {
    connect(action(id), &QAction::triggered, this, std::forward<decltype(run)>(run));
  };
  on("actionPreviousFrame", [this] { timeline_->step(-1); });
  on("actionNow", [this] { selection_->wantNow(); });
  on("actionRerun", [this] {
    if (bridge_ != nullptr && selection_->moment() >= 0) {
      bridge_->session().rerunFrom(selection_->moment());
    }
  });
  on("actionAddMark", [this] { timeline_->addMark(); });
  on("actionRemoveMark", [this] { timeline_->removeMark(); });
  on("actionPreviousMark", [this] { timeline_->stepMark(-1); });
  on("actionNextMark", [this] { timeline_->stepMark(1); });
  on("actionZoomToSpan", [this] { timeline_->zoomToSpan(); });
  connect(document_, &Document::changed, this, [this](const ProjectChanges& changes) {
    const bool again = changes.boxes && followsBoxes(); // that is tracked again by itself
    if (selection_->isPast() && (changes.parameters || changes.targets) && !again) {
      messages_->showNotice(
          tr("The change holds from now on. “%1” shows what it makes of this moment.")
              .arg(action("actionRerun")->text()));
    }
  });
  connect(selection_, &Selection::targetSelected, this, [this] {
    if (shown_ && bridge_ != nullptr) { // a run that rests shows nothing new by itself
      showMoment(*shown_);
    }
  });
  connect(action("actionShowEvidence"), &QAction::toggled, this, [this](bool shown) {
    if (bridge_ != nullptr) {
      bridge_->session().setLikelihoodMapsWanted(shown);
    }
    for (CameraView* camera : cameraViews_) {
      camera->setEvidenceShown(shown);
    }
  });
}

void MainWindow::showMoment(const TrackSnapshot& snapshot) {
  const Session::FramePiece piece =
      bridge_->session().framesSince(frameGeneration_, framePosition_);
  timeline_->append(piece.records, piece.restarted);
  timeline_->show(snapshot);
  const double time = timeline_->model().secondsOf(snapshot.frame);
  selection_->setMoment(snapshot.frame, time, snapshot.past);
  action("actionNow")->setEnabled(snapshot.past);
  figures_->show(snapshot, selection_->target());
  const TargetSnapshot* target = targetToExplain(snapshot, selection_->target());
  for (std::size_t k = 0; k < cameraDocks_.size(); ++k) {
    // That a box is hidden is its state already.
    const bool known = target != nullptr && k < target->reasons.size() &&
                       (!target->box || target->reasons[k].trouble != CameraStatus::Hidden);
    auto* title = static_cast<DockTitle*>(cameraDocks_[k]->titleBarWidget());
    const QString bump = bumpText(bumpOf(snapshot, static_cast<int>(k)));
    title->setReason(!bump.isEmpty() ? bump : known ? troubleText(target->reasons[k]) : QString());
  }
}

} // namespace dewpoint::ui
