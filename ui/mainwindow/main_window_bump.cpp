// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras that are bumped during a run: what is said, and what a click does about it.
#include "core/calibration/manual/interactive_pose.h"
#include "ui/actions/action_registry.h"
#include "ui/calibration/manual_calibration.h"
#include "ui/mainwindow/camera_motion_alerts.h"
#include "ui/mainwindow/main_window.h"
#include "ui/text/camera_motion_text.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QLocale>

namespace dewpoint::ui {

void MainWindow::makeBumps() {
  bumps_ = new CameraMotionAlerts(*messages_, this);
  connect(bumps_, &CameraMotionAlerts::resolveWanted, this, &MainWindow::resolveCamera);
  connect(action("actionResolveCamera"), &QAction::triggered, this, [this] {
    for (int k = 0; k < hand_->cameraCount(); ++k) {
      if (shown_ && bumpOf(*shown_, k) != nullptr) {
        resolveCamera(k);
        return;
      }
    }
    messages_->showNotice(tr("No camera was bumped."));
  });
  connect(bumps_, &CameraMotionAlerts::calibrateWanted, this, [this](int camera) {
    action("actionCalibrateByHand")->setChecked(true);
    hand_->selectCamera(camera);
  });
}

void MainWindow::resolveCamera(int camera) {
  const CameraMotionReport* report = shown_ ? bumpOf(*shown_, camera) : nullptr;
  const QString name = hand_->nameOf(camera);
  if (report == nullptr || !report->resolved) {
    messages_->showNotice(tr("%1 cannot be solved again now.").arg(name));
    return;
  }
  const ResolvedCamera solved = *report->resolved; // the report goes with the next snapshot
  Camera now = hand_->cameraAt(camera);
  now.cameraFromWorld = solved.camera.cameraFromWorld;
  hand_->change(camera, tr("Re-solve %1").arg(name), now);
  QString sentence = tr("%1 is calibrated as it stands now. Undo takes it back.").arg(name);
  if (solved.used > 0) {
    const QLocale locale;
    sentence += QLatin1Char(' ') + tr("The target was %1 px beside where the others see it, and is "
                                      "%2 px now.")
                                       .arg(locale.toString(solved.pixelsBefore, 'f', 1),
                                            locale.toString(solved.pixelsAfter, 'f', 1));
  }
  messages_->showNotice(sentence);
}

} // namespace dewpoint::ui
