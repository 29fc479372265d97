// SPDX-License-Identifier: GPL-3.0-or-later
// The calibration place: a mode of the window, beside views that stay live.
#include "core/session/run/tracking_run.h"
#include "core/session/session.h"
#include "ui/actions/action_registry.h"
#include "ui/calibration/board/board_calibration_page.h"
#include "ui/calibration/board/board_calibrator.h"
#include "ui/calibration/calibration_dock.h"
#include "ui/calibration/manual/grid_layer.h"
#include "ui/calibration/manual/manual_calibration_page.h"
#include "ui/calibration/manual_calibration.h"
#include "ui/calibration/planner/rig_planner.h"
#include "ui/calibration/points/point_calibrator.h"
#include "ui/calibration/wand/wand_calibration_page.h"
#include "ui/calibration/wand/wand_calibrator.h"
#include "ui/document/document.h"
#include "ui/mainwindow/main_window.h"
#include "ui/session/session_bridge.h"
#include "ui/view3d/birds_eye_view.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QDockWidget>

namespace dewpoint::ui {

void MainWindow::makeCalibration() {
  hand_ = new ManualCalibration(*document_, this);
  points_ = new PointCalibrator(*document_, *hand_, this);
  calibration_ = new CalibrationDock(this);
  calibration_->addPage(new ManualCalibrationPage(*hand_, *points_), [] { return tr("By hand"); });
  makeBoardPage();
  auto* wand = new WandCalibrator({*document_, *hand_, *selection_, loader_->opener(),
                                   [this] { return bridge_ ? &bridge_->session() : nullptr; }},
                                  this);
  calibration_->addPage(new WandCalibrationPage(*wand), [] { return tr("Wave"); });
  connect(this, &MainWindow::snapshotShown, wand, &WandCalibrator::setSnapshot);
  connect(wand, &WandCalibrator::failed, this,
          [this](const QString& sentence) { messages_->showError(sentence); });
  connect(wand, &WandCalibrator::saved, this,
          [this](const QString& file) { messages_->showNotice(tr("Saved %1.").arg(file)); });
  makePlan();
  calibrationDock_ = makeDock(
      QStringLiteral("calibrationDock"), [] { return tr("Calibration"); }, calibration_);
  calibrationDock_->setProperty("closedByChoice", true);
  calibrationDock_->setMinimumWidth(400); // room for the names of all tabs, and three numbers
  connect(action("actionCalibrateByHand"), &QAction::triggered, this, [this](bool checked) {
    if (!checked && calibration_->shownPage() != QStringLiteral("handPage")) {
      action("actionCalibrateByHand")->setChecked(true); // another page was in front
    }
  });
  connect(action("actionCalibrateByHand"), &QAction::toggled, this, [this](bool shown) {
    showCalibration(shown);
    if (shown) {
      calibration_->showPage(QStringLiteral("handPage"));
    }
  });
  connect(action("actionCalibrateWand"), &QAction::triggered, this, [this] {
    action("actionCalibrateByHand")->setChecked(true);
    calibration_->showPage(QStringLiteral("wandPage"));
  });
  makeCalibrationFiles();
  connect(calibrationDock_->toggleViewAction(), &QAction::triggered,
          action("actionCalibrateByHand"), &QAction::setChecked);
  connect(hand_, &ManualCalibration::changed, this, &MainWindow::showHandles);
  connect(birdsEye_, &BirdsEyeView::cameraChosen, hand_, &ManualCalibration::selectCamera);
  connect(birdsEye_, &BirdsEyeView::cameraDragged, this,
          [this](int camera, const Eigen::Vector3d& center) {
            hand_->change(camera, tr("Move %1 in the bird's-eye view").arg(hand_->nameOf(camera)),
                          withPosition(hand_->cameraAt(camera), center), "drag center");
          });
  connect(birdsEye_, &BirdsEyeView::cameraAimed, this,
          [this](int camera, const Eigen::Vector3d& target) {
            hand_->change(camera, tr("Turn %1 in the bird's-eye view").arg(hand_->nameOf(camera)),
                          lookingAt(hand_->cameraAt(camera), target), "drag target");
          });
  connect(birdsEye_, &BirdsEyeView::cameraDropped, hand_, &ManualCalibration::endMerging);
}

void MainWindow::makeBoardPage() {
  board_ = new BoardCalibrator(*document_, loader_->opener(), this);
  auto* page = new BoardCalibrationPage(*board_);
  calibration_->addPage(page, [] { return tr("Board"); });
  const auto open = [this] {
    action("actionCalibrateByHand")->setChecked(true);
    calibration_->showPage(QStringLiteral("boardPage"));
  };
  connect(action("actionCalibrateBoard"), &QAction::triggered, this, open);
  connect(action("actionPrintBoard"), &QAction::triggered, page, &BoardCalibrationPage::print);
  connect(calibration_, &CalibrationDock::pageChanged, this, [this] {
    points_->setClicking(false); // its magnifier belongs to the page that was left
    showCalibration(action("actionCalibrateByHand")->isChecked());
  });
  connect(this, &MainWindow::snapshotShown, board_, &BoardCalibrator::setSnapshot);
  connect(board_, &BoardCalibrator::playWanted, this, [this] {
    if (bridge_ != nullptr && shown_ && shown_->state != PlayState::Playing) {
      bridge_->session().play();
    }
  });
  connect(board_, &BoardCalibrator::failed, this,
          [this](const QString& sentence) { messages_->showError(sentence); });
  connect(board_, &BoardCalibrator::saved, this,
          [this](const QString& file) { messages_->showNotice(tr("Saved %1.").arg(file)); });
}

void MainWindow::showCalibration(bool shown) {
  calibrationDock_->setProperty("closedByChoice", !shown);
  calibrationDock_->setVisible(shown);
  if (shown) {
    calibrationDock_->raise();
  }
  // The grid would lie over the board that is shown to the cameras.
  hand_->setActive(shown && calibration_->shownPage() != QStringLiteral("boardPage"));
}

void MainWindow::showHandles() {
  std::vector<BirdsEyeView::CameraHandle> handles;
  CameraRig rig = rigOf(document_->project());
  rig.insert(rig.end(), plan_->planned().begin(), plan_->planned().end());
  for (std::size_t k = 0; hand_->isActive() && k < rig.size(); ++k) {
    const Camera& camera = rig[k];
    // As far away as what they look at: mostly within the picture.
    const double distance = (hand_->grid().middle() - camera.center()).norm();
    handles.push_back({camera.center(), camera.center() + distance * camera.opticalAxis()});
  }
  const int planned = plan_->chosen();
  birdsEye_->setCameraHandles(std::move(handles),
                              planned < 0 ? hand_->camera() : hand_->cameraCount() + planned);
}

void MainWindow::takeCalibration() {
  if (bridge_ == nullptr) {
    return;
  }
  const CameraRig rig = rigOf(document_->project());
  const auto shown = bridge_->session().newest();
  if (shown->rig && haveSameImages(rig, *shown->rig)) {
    bridge_->session().setCameras(rig); // the run goes on
  } else {
    reopen();
  }
}

} // namespace dewpoint::ui
