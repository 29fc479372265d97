// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/planner/planner_installer.h"

#include "core/calibration/manual/interactive_pose.h"
#include "core/project/project.h"
#include "core/session/run/tracking_run.h"
#include "ui/calibration/calibration_mode.h"
#include "ui/calibration/manual_calibration.h"
#include "ui/calibration/planner/plan_page.h"
#include "ui/calibration/planner/rig_planner.h"
#include "ui/document/document.h"
#include "ui/view3d/birds_eye_view.h"

#include <QAction>
#include <QMainWindow>

#include <utility>

namespace dewpoint::ui {

PlannerInstaller::PlannerInstaller(const Workbench& bench, CalibrationMode& mode,
                                   BirdsEyeView& birdsEye)
    : QObject(&bench.window), bench_(bench), mode_(mode), birdsEye_(birdsEye),
      manual_(mode.manualCalibration()),
      plan_(new RigPlanner(bench.document, mode.manualCalibration(), bench.selection, this)) {
  mode_.addPage(new PlanPage(*plan_), [] { return PlanPage::tr("Plan"); });
  connect(plan_, &RigPlanner::mapChanged, this, [this] {
    const bool shown = plan_->isMapShown() && manual_.isActive();
    birdsEye_.showMap(shown ? plan_->map() : nullptr, plan_->mapOptions());
  });
  connect(plan_, &RigPlanner::changed, this, [this] {
    birdsEye_.showPlannedCameras(manual_.isActive() ? plan_->plannedCameras() : CameraRig());
    bench_.action("actionShowMap")->setChecked(plan_->isMapShown());
    showHandles();
  });
  connect(&manual_, &ManualCalibration::changed, this, &PlannerInstaller::showHandles);
  connectBirdsEye();
  connectActions();
}

int PlannerInstaller::plannedIndex(int handle) const {
  return handle - manual_.cameraCount();
}

void PlannerInstaller::connectBirdsEye() {
  connect(&birdsEye_, &BirdsEyeView::cameraChosen, this, [this](int camera) {
    plan_->selectCamera(plannedIndex(camera));
    manual_.selectCamera(camera);
  });
  connect(&birdsEye_, &BirdsEyeView::cameraDragged, this,
          [this](int camera, const Eigen::Vector3d& center) {
            if (const int k = plannedIndex(camera); k >= 0) {
              plan_->changeCamera(k, withPosition(plan_->plannedCameras()[std::size_t(k)], center));
            }
            manual_.changeCamera(
                camera, tr("Move %1 in the bird's-eye view").arg(manual_.nameOf(camera)),
                withPosition(manual_.cameraInProject(camera), center), "drag center");
          });
  connect(&birdsEye_, &BirdsEyeView::cameraAimed, this,
          [this](int camera, const Eigen::Vector3d& target) {
            if (const int k = plannedIndex(camera); k >= 0) {
              plan_->changeCamera(k, lookingAt(plan_->plannedCameras()[std::size_t(k)], target));
            }
            manual_.changeCamera(camera,
                                 tr("Turn %1 in the bird's-eye view").arg(manual_.nameOf(camera)),
                                 lookingAt(manual_.cameraInProject(camera), target), "drag target");
          });
  connect(&birdsEye_, &BirdsEyeView::cameraDropped, &manual_, &ManualCalibration::endStepMerging);
}

void PlannerInstaller::connectActions() {
  bench_.onTriggered("actionPlanRig", this, [this] { open(); });
  bench_.onToggled("actionShowMap", this, [this](bool shown) {
    if (shown && !manual_.isActive()) {
      open();
    }
    plan_->setMapShown(shown);
  });
  bench_.onTriggered("actionPlanCamera", this, [this] {
    open();
    plan_->addCamera();
  });
  bench_.onTriggered("actionFindPlace", this, [this] {
    open();
    plan_->findBestCameraPosition();
  });
  bench_.requireRun({"actionPlanRig", "actionShowMap", "actionPlanCamera", "actionFindPlace"});
}

void PlannerInstaller::showHandles() {
  std::vector<CameraHandle> handles;
  CameraRig rig = rigOf(bench_.document.project());
  rig.insert(rig.end(), plan_->plannedCameras().begin(), plan_->plannedCameras().end());
  for (std::size_t k = 0; manual_.isActive() && k < rig.size(); ++k) {
    const Camera& camera = rig[k];
    // As far away as what they look at: mostly within the picture.
    const double distance = (manual_.grid().center() - camera.center()).norm();
    handles.push_back({camera.center(), camera.center() + distance * camera.opticalAxis()});
  }
  const int chosen = plan_->selectedCamera();
  birdsEye_.setCameraHandles(std::move(handles),
                             chosen < 0 ? manual_.camera() : manual_.cameraCount() + chosen);
}

void PlannerInstaller::open() {
  mode_.open(QStringLiteral("planPage"));
}

} // namespace dewpoint::ui
