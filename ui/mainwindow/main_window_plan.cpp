// SPDX-License-Identifier: GPL-3.0-or-later
// The rig planner: its page, the map in the bird's-eye view, and planned cameras dragged there.
#include "core/calibration/manual/interactive_pose.h"
#include "ui/actions/action_registry.h"
#include "ui/calibration/calibration_dock.h"
#include "ui/calibration/manual_calibration.h"
#include "ui/calibration/planner/plan_page.h"
#include "ui/calibration/planner/rig_planner.h"
#include "ui/mainwindow/main_window.h"
#include "ui/view3d/birds_eye_view.h"

#include <QAction>

namespace dewpoint::ui {

void MainWindow::makePlan() {
  plan_ = new RigPlanner(*document_, *hand_, this);
  calibration_->addPage(new PlanPage(*plan_), [] { return tr("Plan"); });
  connect(plan_, &RigPlanner::mapChanged, this, [this] {
    const bool shown = plan_->isMapShown() && hand_->isActive();
    birdsEye_->showMap(shown ? plan_->map() : nullptr, plan_->look());
  });
  connect(plan_, &RigPlanner::changed, this, [this] {
    birdsEye_->showPlanned(hand_->isActive() ? plan_->planned() : CameraRig());
    action("actionShowMap")->setChecked(plan_->isMapShown());
    showHandles();
  });
  const auto planned = [this](int camera) { return camera - hand_->cameraCount(); };
  connect(birdsEye_, &BirdsEyeView::cameraChosen, this,
          [this, planned](int camera) { plan_->choose(planned(camera)); });
  connect(birdsEye_, &BirdsEyeView::cameraDragged, this,
          [this, planned](int camera, const Eigen::Vector3d& center) {
            if (const int k = planned(camera); k >= 0) {
              plan_->change(k, withPosition(plan_->planned()[std::size_t(k)], center));
            }
          });
  connect(birdsEye_, &BirdsEyeView::cameraAimed, this,
          [this, planned](int camera, const Eigen::Vector3d& target) {
            if (const int k = planned(camera); k >= 0) {
              plan_->change(k, lookingAt(plan_->planned()[std::size_t(k)], target));
            }
          });
  connect(action("actionPlanRig"), &QAction::triggered, this, &MainWindow::openPlan);
  connect(action("actionShowMap"), &QAction::toggled, this, [this](bool shown) {
    if (shown && !hand_->isActive()) {
      openPlan();
    }
    plan_->setMapShown(shown);
  });
  connect(action("actionPlanCamera"), &QAction::triggered, this, [this] {
    openPlan();
    plan_->add();
  });
  connect(action("actionFindPlace"), &QAction::triggered, this, [this] {
    openPlan();
    plan_->findPlace();
  });
}

void MainWindow::openPlan() {
  action("actionCalibrateByHand")->setChecked(true);
  calibration_->showPage(QStringLiteral("planPage"));
}

} // namespace dewpoint::ui
