// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/camera_motion_text.h"

#include "ui/text/quantity_text.h"

#include <QCoreApplication>

namespace dewpoint::ui {

const CameraMotionReport* cameraMotionOf(const TrackSnapshot& snapshot, int camera) {
  const CameraMotionReport* found = nullptr;
  for (const CameraMotionReport& report : snapshot.cameraMotions) {
    if (static_cast<int>(report.event.camera) == camera && !report.isBackInPose) {
      found = &report;
    }
  }
  return found;
}

QString cameraMotionText(const CameraMotionReport* report) {
  if (report == nullptr) {
    return {};
  }
  return QCoreApplication::translate("CameraMotion", "rotated by %1")
      .arg(angleText(report->event.rotation.turn.norm(), 2));
}

} // namespace dewpoint::ui
