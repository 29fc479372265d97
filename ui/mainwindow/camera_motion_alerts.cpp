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
  withdraw();
}

void CameraMotionAlerts::setSnapshot(const TrackSnapshotPtr& shown) {
  if (!shown) {
    clear();
    return;
  }
  const TrackSnapshot& snapshot = *shown;
  const double now = snapshot.frames ? seconds(snapshot.frames->time) : 0.0;
  const CameraMotionMessages::NewMessages news = news_.update(snapshot.cameraMotions, now);
  if (news.withdrawsEarlierMessages) {
    withdraw();
  }
  const QStringList names = cameraNames(snapshot);
  for (const auto& [report, stage] : news.messages) {
    showAlert(report, stage, names.value(static_cast<int>(report.event.camera)));
  }
}

void CameraMotionAlerts::withdraw() {
  if (!notice_.isEmpty() && bar_.text() == notice_) {
    bar_.dismiss();
  }
  notice_.clear();
  while (!questions_.empty()) {
    withdraw(questions_.begin()->first);
  }
}

void CameraMotionAlerts::withdraw(int camera) {
  if (const auto asked = questions_.extract(camera)) {
    bar_.withdrawQuestion(asked.mapped());
  }
}

void CameraMotionAlerts::ask(int camera, const QString& question, const QString& answer,
                             void (CameraMotionAlerts::*answered)(int)) {
  const auto report = [this, camera, answered] { (this->*answered)(camera); }; // a signal
  bar_.showLastingQuestion(question, {{answer, report}});
  questions_[camera] = question;
}

void CameraMotionAlerts::showAlert(const CameraMotionReport& report, CameraMotionStage stage,
                                   const QString& name) {
  const int camera = static_cast<int>(report.event.camera);
  const QString what = tr("%1 was rotated by %2 (frame %3).")
                           .arg(name, angleText(report.event.rotation.turn.norm(), 2))
                           .arg(frameNumberText(report.event.frame)) +
                       QLatin1Char(' ');
  withdraw(camera);
  switch (stage) {
  case CameraMotionStage::Waiting:
    notice_ = what + tr("The new pose of this camera is being computed.");
    bar_.showNotice(notice_);
    break;
  case CameraMotionStage::Solved:
    ask(camera, what + tr("The pose of this camera can be recomputed from its images."),
        tr("Recompute pose of %1").arg(name), &CameraMotionAlerts::newPoseRequested);
    break;
  case CameraMotionStage::Unsolvable:
    ask(camera,
        what + tr("The pose of this camera cannot be recomputed from its images: calibrate the "
                  "camera again, or move it back."),
        tr("Calibrate %1…").arg(name), &CameraMotionAlerts::calibrationRequested);
    break;
  case CameraMotionStage::Back:
    notice_ = tr("%1 is back in its calibrated pose.").arg(name);
    bar_.showNotice(notice_);
    break;
  }
}

} // namespace dewpoint::ui
