// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/view3d/view_projection.h"

#include <QRectF>
#include <QString>

#include <vector>

class QPainter;

namespace dewpoint::ui {

/// Names of the cameras beside their viewing pyramids.
class CameraLabels {
public:
  explicit CameraLabels(const Scene3d& scene) : scene_(scene) {}

  struct Label {
    QString text;
    QRectF place; ///< view coordinates
  };
  /// Returns the labels. They avoid all pyramids, the numbers on the floor and each other if there
  /// is room. Cameras outside the picture have none.
  std::vector<Label> labels(const QWidget& view) const;
  void paint(QPainter& painter, const QWidget& view) const;

private:
  const Scene3d& scene_;
};

} // namespace dewpoint::ui
