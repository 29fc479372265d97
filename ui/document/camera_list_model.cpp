// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/camera_list_model.h"

#include "core/project/project.h"
#include "ui/document/document.h"
#include "ui/text/camera_names.h"

namespace dewpoint::ui {

CameraListModel::CameraListModel(const Document& document, QObject* parent)
    : NameListModel(parent), document_(document) {
  connect(&document_, &Document::projectReplaced, this, &CameraListModel::refresh);
  connect(&document_, &Document::changed, this, &CameraListModel::refresh);
  refresh();
}

QString CameraListModel::nameOf(int camera) const {
  const auto& cameras = document_.project().cameras;
  const auto index = static_cast<std::size_t>(camera);
  return cameraName(index < cameras.size() ? cameras[index].camera.name : std::string(), index);
}

void CameraListModel::refresh() {
  QStringList names;
  for (int k = 0; k < static_cast<int>(document_.project().cameras.size()); ++k) {
    names << nameOf(k);
  }
  setNames(names);
}

} // namespace dewpoint::ui
