// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/view_picture.h"

#include "core/base/text_file.h"
#include "ui/view3d/birds_eye_view.h"

#include <QBuffer>
#include <QPixmap>
#include <QWidget>

namespace dewpoint::ui {

QImage grabView(QWidget* view) {
  auto* birdsEye = qobject_cast<BirdsEyeView*>(view);
  const QImage picture = birdsEye == nullptr ? QImage() : birdsEye->currentImage();
  return picture.isNull() ? view->grab().toImage() : picture;
}

Status writePng(const QImage& picture, const std::filesystem::path& file) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  if (!picture.save(&buffer, "PNG")) {
    return failure(ErrorCode::FileUnwritable, file.string(), "", "there is no picture");
  }
  return writeTextFile(file, buffer.data().toStdString());
}

} // namespace dewpoint::ui
