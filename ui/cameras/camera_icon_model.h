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

/// Size of the small images in lists of cameras, in pixels. Chosen: large enough to recognize a
/// view, small enough for four rows beside each other.
inline constexpr QSize kCameraIconSize(96, 54);

/// Returns an image centered in a tile of kCameraIconSize, so that rows are alike; an empty
/// tile without an image.
QIcon cameraIcon(const QImage& image, const QPalette& palette, double pixelRatio);

/// The list of the project's cameras (CameraListModel), with their newest images.
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
