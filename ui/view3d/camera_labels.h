// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/view3d/view_projection.h"

#include <QRectF>
#include <QString>

#include <vector>

class QPainter;

namespace dewpoint::ui {

/// Labels with the camera names, next to the viewing pyramids in the bird's-eye view.
class CameraLabels {
public:
  explicit CameraLabels(const Scene3d& scene) : scene_(scene) {}

  struct Label {
    QString text;
    QRectF area; ///< area of the label, view coordinates
  };
  /// Returns the labels. If there is room, they avoid all pyramids, the floor numbers, each other,
  /// and the area `taken` (view coordinates). Cameras outside the rendered image have no labels.
  std::vector<Label> labels(const QWidget& view, const QRectF& taken = {}) const;
  void paint(QPainter& painter, const QWidget& view, const QRectF& taken) const;

private:
  const Scene3d& scene_;
};

} // namespace dewpoint::ui
