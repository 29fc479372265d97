// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/view3d/view_projection.h"

#include <QRectF>
#include <QString>

#include <vector>

class QPainter;

namespace dewpoint::ui {

/// The names of the cameras, written beside the pyramids that stand for them.
class CameraLabels {
public:
  explicit CameraLabels(const Scene3d& scene) : scene_(scene) {}

  struct Label {
    QString text;
    QRectF place; ///< in the view
  };
  /// Where they stand: beside all pyramids, the numbers at the floor and each other, where there is
  /// room. Cameras that are
  /// not in the picture have none.
  std::vector<Label> labels(const QWidget& view) const;
  void paint(QPainter& painter, const QWidget& view) const;

private:
  const Scene3d& scene_;
};

} // namespace dewpoint::ui
