// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QIcon>
#include <QIdentityProxyModel>
#include <QImage>
#include <QSize>

#include <vector>

class QPalette;

namespace dewpoint::ui {

/// Size of the small images in lists of cameras, in pixels: large enough to recognize a view, small
/// enough to show four cameras at once.
inline constexpr QSize kCameraIconSize(96, 54);

/// Returns an icon of kCameraIconSize with the image at its center, so that all rows of a list are
/// equally tall. Returns an empty tile if the image is null.
QIcon cameraIcon(const QImage& image, const QPalette& palette, double pixelRatio);

/// List model of the project's cameras (CameraListModel) with small images of the cameras as icons.
class CameraIconModel : public QIdentityProxyModel {
  Q_OBJECT
public:
  explicit CameraIconModel(QAbstractItemModel& cameras, QObject* parent = nullptr);

  void setIcons(std::vector<QIcon> icons);
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
  std::vector<QIcon> icons_;
};

} // namespace dewpoint::ui
