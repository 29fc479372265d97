// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/run_alerts.h"

#include "core/calibration/manual/interactive_pose.h"
#include "core/session/snapshot/snapshot.h"
#include "core/session/watch/camera_repair.h"
#include "ui/calibration/calibration_mode.h"
#include "ui/calibration/manual_calibration.h"
#include "ui/document/document.h"
#include "ui/mainwindow/camera_agreement_alerts.h"
#include "ui/mainwindow/camera_motion_alerts.h"
#include "ui/text/camera_agreement_text.h"
#include "ui/text/camera_motion_text.h"
#include "ui/text/error_sentence.h"
#include "ui/text/quantity_text.h"
#include "ui/text/reason_text.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/notice_list.h"

#include <QAction>
#include <QMainWindow>
#include <QStatusBar>
#include <QToolButton>

#include <algorithm>

namespace dewpoint::ui {

RunAlerts::RunAlerts(const Workbench& bench, NoticeList& notices, CalibrationMode& calibration)
    : QObject(&bench.window), bench_(bench), notices_(notices),
      manual_(calibration.manualCalibration()) {
  auto* alerts = new CameraMotionAlerts(bench_.messages, this);
  connect(&bench_.session, &SessionController::snapshotChanged, this, &RunAlerts::showNotices);
  bench_.connectView(alerts);
  connect(alerts, &CameraMotionAlerts::newPoseRequested, this, &RunAlerts::applyNewPose);
  connect(alerts, &CameraMotionAlerts::calibrationRequested, this, &RunAlerts::calibrate);
  connectAgreement(calibration);
  addHiddenButton();
  connect(&notices_, &NoticeList::noticeBegan, this,
          [this](const QString& notice) { bench_.messages.record(notice, Severity::Warning); });
  connect(&notices_, &NoticeList::noticeEnded, this, [this](const QString& notice) {
    bench_.messages.record(tr("No longer applies: %1").arg(notice), Severity::Information);
  });
  bench_.onTriggered("actionResolveCamera", this, [this] { applyFirstNewPose(); });
  bench_.requireRun({"actionResolveCamera"});
  connect(&bench_.session, &SessionController::failed, &bench_.messages, &MessageBar::showError);
}

void RunAlerts::connectAgreement(const CalibrationMode& calibration) {
  auto* alerts = new CameraAgreementAlerts(bench_.messages, this);
  connect(&calibration, &CalibrationMode::pageShown, alerts,
          [alerts](const QString& page) { alerts->setSuppressed(!page.isEmpty()); });
  bench_.connectView(alerts);
  connect(alerts, &CameraAgreementAlerts::rigCorrectionRequested, this, &RunAlerts::correctRig);
  connect(alerts, &CameraAgreementAlerts::calibrationRequested, this, &RunAlerts::calibrate);
}

void RunAlerts::calibrate(int camera) {
  bench_.action("actionCalibrateByHand")->setChecked(true);
  manual_.selectCamera(camera);
}

void RunAlerts::correctRig(const CameraDisagreement& found, std::size_t choice) {
  const TrackSnapshotPtr& shown = bench_.session.shownSnapshot();
  if (!shown) {
    return;
  }
  const QString step = rigCorrectionText(found, choice, cameraNames(*shown));
  const auto mended =
      bench_.document.edit(step, [&](Project& project) { repairCameras(project, found, choice); });
  if (mended) {
    bench_.messages.showNotice(tr("Done: %1. You can undo this.").arg(step));
  } else {
    bench_.messages.showError(errorText(mended.error()));
  }
}

void RunAlerts::showNotices(const TrackSnapshotPtr& snapshot) {
  QStringList texts;
  if (snapshot) {
    // A camera that was moved is said with what can be done about it.
    const std::size_t count = snapshot->notices.size() -
                              std::min(snapshot->cameraMotions.size(), snapshot->notices.size());
    for (std::size_t k = 0; k < count; ++k) {
      texts += errorText(snapshot->notices[k]);
    }
  }
  notices_.setNotices(texts);
}

void RunAlerts::addHiddenButton() {
  auto* button = new QToolButton(&bench_.window);
  button->setObjectName(QStringLiteral("hiddenNotices"));
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);
  button->hide();
  bench_.window.statusBar()->addPermanentWidget(button);
  const auto update = [this, button] {
    const auto count = static_cast<int>(notices_.hiddenCount());
    button->setText(tr("◆ %n notice(s)", nullptr, count));
    button->setToolTip(tr("Show the hidden notices"));
    button->setVisible(count > 0);
  };
  connect(&notices_, &NoticeList::hiddenCountChanged, button, update);
  connect(button, &QToolButton::clicked, &notices_, &NoticeList::showAll);
  onRetranslate(button, update);
}

void RunAlerts::applyFirstNewPose() {
  const TrackSnapshotPtr& shown = bench_.session.shownSnapshot();
  for (int k = 0; k < manual_.cameraCount(); ++k) {
    if (shown && cameraMotionOf(*shown, k) != nullptr) {
      applyNewPose(k);
      return;
    }
  }
  bench_.messages.showNotice(tr("No camera has moved."));
}

void RunAlerts::applyNewPose(int camera) {
  const TrackSnapshotPtr& shown = bench_.session.shownSnapshot();
  const CameraMotionReport* report = shown ? cameraMotionOf(*shown, camera) : nullptr;
  const QString name = manual_.nameOf(camera);
  if (report == nullptr || !report->newPose) {
    bench_.messages.showNotice(tr("The pose of %1 cannot be recomputed now.").arg(name));
    return;
  }
  const MovedCameraPose solved = *report->newPose; // the report goes with the next snapshot
  Camera now = manual_.cameraInProject(camera);
  now.cameraFromWorld = solved.camera.cameraFromWorld;
  manual_.changeCamera(camera, tr("Recompute pose of %1").arg(name), now);
  QString sentence =
      tr("The pose of %1 was recomputed. Undo restores the previous pose.").arg(name);
  if (solved.usedSightingCount > 0) {
    sentence += QLatin1Char(' ') + tr("Disagreement with the other cameras: %1 before, %2 now.")
                                       .arg(pixelText(solved.medianResidualPxBefore),
                                            pixelText(solved.medianResidualPxAfter));
  }
  bench_.messages.showNotice(sentence);
}

} // namespace dewpoint::ui
