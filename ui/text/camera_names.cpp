// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/camera_names.h"

#include <QCoreApplication>

namespace dewpoint::ui {

QString cameraName(const std::string& name, std::size_t camera) {
  return name.empty() ? QCoreApplication::translate("CameraNames", "camera %1").arg(camera + 1)
                      : QString::fromStdString(name);
}

QString cameraName(const CameraRig& rig, std::size_t camera) {
  return cameraName(camera < rig.size() ? rig[camera].name : std::string(), camera);
}

QStringList cameraNames(const CameraRig& rig) {
  QStringList names;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    names << cameraName(rig, k);
  }
  return names;
}

} // namespace dewpoint::ui
