// SPDX-License-Identifier: GPL-3.0-or-later
// What plots, trajectory and bird's-eye view tell each other beyond the selection.
#include "core/setup/new_project.h"
#include "ui/actions/action_registry.h"
#include "ui/document/document.h"
#include "ui/mainwindow/main_window.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_stack.h"
#include "ui/timeline/timeline.h"
#include "ui/trajectory/trajectory_panel.h"
#include "ui/view3d/birds_eye_view.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QDockWidget>

#include <algorithm>

namespace dewpoint::ui {

void MainWindow::linkViews() {
  connect(plot_, &PlotPanel::notice, messages_, &MessageBar::showNotice);
  connect(plot_, &PlotPanel::failed, messages_, &MessageBar::showError);
  connect(trajectory_, &TrajectoryPanel::notice, messages_, &MessageBar::showNotice);
  connect(trajectory_, &TrajectoryPanel::highlightChanged, birdsEye_, &BirdsEyeView::highlight);
  connect(birdsEye_, &BirdsEyeView::tailClicked, trajectory_, &TrajectoryPanel::choosePlace);
  plot_->stack().shareCursor(trajectory_->plots());
  for (PlotStack* stack : {&plot_->stack(), &trajectory_->plots()}) {
    connect(stack, &PlotStack::hovered, timeline_, &Timeline::setHovered);
    connect(timeline_, &Timeline::hovered, stack, [stack](qint64 frame) {
      stack->setHovered(frame < 0 ? std::nullopt : std::optional<std::int64_t>(frame));
    });
  }
}

bool MainWindow::followsBoxes() const {
  return methodFamily(document_->project().method) == MethodFamily::Boxes;
}

/// What goes with the kind of method: boxes in images have no place in the room.
void MainWindow::showFamily() {
  const bool boxes = followsBoxes();
  actions_->rename(action("actionLearnColor"),
                   boxes ? QT_TRANSLATE_NOOP("Actions", "Take a box")
                         : QT_TRANSLATE_NOOP("Actions", "Learn the color"),
                   "learn");
  for (const char* id : {"actionShowMask", "actionShowEvidence"}) {
    action(id)->setEnabled(bridge_ != nullptr && !boxes);
  }
  if (bridge_ != nullptr && birdsEyeDock_->isHidden() != boxes) {
    birdsEyeDock_->setVisible(!boxes && !birdsEyeDock_->property("closedByChoice").toBool());
    if (document_->project().layout.empty()) { // else it is as the person wanted it
      QMetaObject::invokeMethod(this, &MainWindow::shareSpace, Qt::QueuedConnection);
    }
  }
}

void MainWindow::sayWhatMethodNeeds() {
  const Project& project = document_->project();
  const auto hasBox = [](const Target& target) { return target.box.has_value(); };
  if (followsBoxes()) {
    if (std::ranges::none_of(project.targets, hasBox)) {
      messages_->showNotice(tr("Click the thing or drag a box around it in any camera view."));
    }
  } else if (isGuessed(project)) {
    messages_->showNotice(
        tr("This method works in the room: calibrate the cameras first (menu Calibration), their "
           "positions are only a guess."));
  }
}

} // namespace dewpoint::ui
