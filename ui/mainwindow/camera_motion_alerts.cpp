// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/camera_motion_alerts.h"

#include "ui/text/quantity_text.h"
#include "ui/text/reason_text.h"
#include "ui/widgets/message_bar.h"

namespace dewpoint::ui {

CameraMotionAlerts::CameraMotionAlerts(MessageBar& bar, QObject* parent)
    : QObject(parent), bar_(bar) {}

void CameraMotionAlerts::clear() {
  news_.clear();
  text_.clear();
}

void CameraMotionAlerts::setSnapshot(const TrackSnapshotPtr& shown) {
  if (!shown) {
    clear();
    return;
  }
  const TrackSnapshot& snapshot = *shown;
  const double now = snapshot.frames ? seconds(snapshot.frames->time) : 0.0;
  const CameraMotionMessages::News news = news_.take(snapshot.cameraMotions, now);
  if (news.withdrawn) {
    withdraw();
  }
  const QStringList names = cameraNames(snapshot);
  for (const auto& [report, stage] : news.items) {
    showAlert(report, stage, names.value(static_cast<int>(report.event.camera)));
  }
}

void CameraMotionAlerts::withdraw() {
  if (!text_.isEmpty() && bar_.text() == text_) {
    bar_.dismiss();
  }
  text_.clear();
}

void CameraMotionAlerts::showAlert(const CameraMotionReport& report, CameraMotionStage stage,
                                   const QString& name) {
  const int camera = static_cast<int>(report.event.camera);
  const QString what = tr("%1 was rotated by %2 (frame %3).")
                           .arg(name, angleText(report.event.turn.turn.norm(), 2))
                           .arg(static_cast<qlonglong>(report.event.frame));
  switch (stage) {
  case CameraMotionStage::Waiting:
    bar_.showNotice(what + QLatin1Char(' ') + tr("The new pose of this camera is being computed."));
    break;
  case CameraMotionStage::Solved:
    bar_.ask(what + QLatin1Char(' ') +
                 tr("The pose of this camera can be recomputed from its images."),
             {{tr("Recompute pose of %1").arg(name),
               [this, camera] { Q_EMIT newPoseRequested(camera); }}});
    break;
  case CameraMotionStage::Unsolvable:
    bar_.ask(
        what + QLatin1Char(' ') +
            tr("The pose of this camera cannot be recomputed from its images: calibrate the camera "
               "again, or move it back."),
        {{tr("Calibrate %1…").arg(name), [this, camera] { Q_EMIT calibrationRequested(camera); }}});
    break;
  case CameraMotionStage::Back:
    bar_.showNotice(tr("%1 is back in its calibrated pose.").arg(name));
    break;
  }
  text_ = bar_.text();
}

} // namespace dewpoint::ui
