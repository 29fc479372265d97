// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/camera_icon_model.h"

#include <QPainter>
#include <QPalette>
#include <QPixmap>

#include <utility>

namespace dewpoint::ui {

QIcon cameraIcon(const QImage& image, const QPalette& palette, double pixelRatio) {
  QPixmap tile(kCameraIconSize * pixelRatio);
  tile.setDevicePixelRatio(pixelRatio);
  tile.fill(palette.color(QPalette::Button));
  if (!image.isNull()) {
    QPainter painter(&tile);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    QRect area(QPoint(), image.size().scaled(kCameraIconSize, Qt::KeepAspectRatio));
    area.moveCenter(QRect(QPoint(), kCameraIconSize).center());
    painter.drawImage(area, image);
  }
  QIcon icon(tile);
  icon.addPixmap(tile, QIcon::Selected); // an image keeps its colors in a selected row
  return icon;
}

CameraIconModel::CameraIconModel(QAbstractItemModel& cameras, QObject* parent)
    : QIdentityProxyModel(parent) {
  setSourceModel(&cameras);
}

void CameraIconModel::setIcons(std::vector<QIcon> icons) {
  icons_ = std::move(icons);
  if (rowCount() > 0) {
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, 0), {Qt::DecorationRole});
  }
}

QVariant CameraIconModel::data(const QModelIndex& index, int role) const {
  const auto row = static_cast<std::size_t>(index.row());
  if (role == Qt::DecorationRole && index.isValid() && row < icons_.size()) {
    return icons_[row];
  }
  return QIdentityProxyModel::data(index, role);
}

} // namespace dewpoint::ui
