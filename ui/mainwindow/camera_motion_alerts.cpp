// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/camera_motion_alerts.h"

#include "ui/text/camera_motion_text.h"
#include "ui/text/reason_text.h"
#include "ui/widgets/message_bar.h"

namespace dewpoint::ui {

namespace {
/// A pose that is not known then will hardly be (it is looked for about once a second).
constexpr double kPatience = 3.0; // seconds of the run
} // namespace

CameraMotionAlerts::CameraMotionAlerts(MessageBar& bar, QObject* parent)
    : QObject(parent), bar_(bar) {}

void CameraMotionAlerts::clear() {
  said_.clear();
  count_ = 0;
  text_.clear();
}

CameraMotionAlerts::Stage CameraMotionAlerts::stageOf(const CameraMotionReport& report,
                                                      const TrackSnapshot& snapshot) {
  if (report.back) {
    return Stage::Back;
  }
  if (report.resolved) {
    return Stage::Solved;
  }
  const double now = snapshot.frames ? seconds(snapshot.frames->time) : 0.0;
  return now - seconds(report.event.time) > kPatience ? Stage::Unsolvable : Stage::Waiting;
}

void CameraMotionAlerts::setSnapshot(const TrackSnapshotPtr& shown) {
  if (!shown) {
    clear();
    return;
  }
  const TrackSnapshot& snapshot = *shown;
  if (snapshot.bumps.size() < count_) { // one was dealt with: the others are worth saying again
    said_.clear();
    withdraw();
  }
  count_ = snapshot.bumps.size();
  const QStringList names = cameraNames(snapshot);
  for (const CameraMotionReport& report : snapshot.bumps) {
    const Stage stage = stageOf(report, snapshot);
    const auto key = [&](Stage one) { return Key{report.event.camera, report.event.frame, one}; };
    // A pose that is known now and then stays on offer.
    const bool worse = stage == Stage::Waiting || stage == Stage::Unsolvable;
    if (worse && said_.contains(key(Stage::Solved))) {
      continue;
    }
    if (said_.insert(key(stage)).second) {
      say(report, stage, names.value(static_cast<int>(report.event.camera)));
    }
  }
}

void CameraMotionAlerts::withdraw() {
  if (!text_.isEmpty() && bar_.text() == text_) {
    bar_.close();
  }
  text_.clear();
}

void CameraMotionAlerts::say(const CameraMotionReport& report, Stage stage, const QString& name) {
  const int camera = static_cast<int>(report.event.camera);
  const QString what = tr("%1 was %2 (frame %3).")
                           .arg(name, bumpText(&report))
                           .arg(static_cast<qlonglong>(report.event.frame));
  switch (stage) {
  case Stage::Waiting:
    bar_.showNotice(what + QLatin1Char(' ') + tr("Its new pose is being worked out."));
    break;
  case Stage::Solved:
    bar_.ask(what + QLatin1Char(' ') + tr("Its pose can be solved again from what it sees."),
             {{tr("Re-solve %1").arg(name), [this, camera] { Q_EMIT resolveWanted(camera); }}});
    break;
  case Stage::Unsolvable:
    bar_.ask(what + QLatin1Char(' ') +
                 tr("It cannot be solved again from what it sees: calibrate it anew, or put it "
                    "back."),
             {{tr("Calibrate %1…").arg(name), [this, camera] { Q_EMIT calibrateWanted(camera); }}});
    break;
  case Stage::Back:
    bar_.showNotice(tr("%1 stands again as it was calibrated.").arg(name));
    break;
  }
  text_ = bar_.text();
}

} // namespace dewpoint::ui
