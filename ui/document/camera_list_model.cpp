// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/camera_list_model.h"

#include "core/project/project.h"
#include "ui/document/document.h"

namespace dewpoint::ui {

CameraListModel::CameraListModel(const Document& document, QObject* parent)
    : NameListModel(parent), document_(document) {
  connect(&document_, &Document::replaced, this, &CameraListModel::refresh);
  connect(&document_, &Document::changed, this, &CameraListModel::refresh);
  refresh();
}

QString CameraListModel::nameOf(int camera) const {
  const auto& cameras = document_.project().cameras;
  const auto index = static_cast<std::size_t>(camera);
  const QString name =
      index < cameras.size() ? QString::fromStdString(cameras[index].camera.name) : QString();
  return name.isEmpty() ? tr("camera %1").arg(camera + 1) : name;
}

void CameraListModel::refresh() {
  QStringList names;
  for (int k = 0; k < static_cast<int>(document_.project().cameras.size()); ++k) {
    names << nameOf(k);
  }
  setNames(names);
}

} // namespace dewpoint::ui
