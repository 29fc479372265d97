// SPDX-License-Identifier: GPL-3.0-or-later
// What plots, trajectory and bird's-eye view tell each other beyond the selection.
#include "ui/birdseye/birds_eye_view.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/message_bar.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_stack.h"
#include "ui/timeline/timeline.h"
#include "ui/trajectory/trajectory_panel.h"

namespace dewpoint {

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

} // namespace dewpoint
