// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene3d.h"

#include <QPointF>
#include <QWidget>

namespace dewpoint::ui {

/// Converts between positions in a scene and positions in a widget that shows the whole rendered
/// image.
class ViewProjection {
public:
  ViewProjection(const QWidget& view, const Scene3d& scene) : view_(view), scene_(scene) {}

  /// Returns the widget position (pixels) of a world point (meters).
  QPointF toWidget(const Eigen::Vector3d& point) const {
    return toWidget(scene_.projectToImage(point));
  }
  /// Returns the widget position of a position in the rendered image, given in device pixels to the
  /// right of and above the center.
  QPointF toWidget(const Eigen::Vector2d& picture) const {
    const Eigen::Vector2d place = picture / view_.devicePixelRatioF();
    return {view_.width() / 2.0 + place.x(), view_.height() / 2.0 - place.y()};
  }
  /// Converts a position in the widget to a position in the rendered image, given in device pixels
  /// to the right of its center and above it.
  Eigen::Vector2d toRenderedImage(QPointF position) const {
    const QPointF middle(view_.width() / 2.0, view_.height() / 2.0);
    const QPointF offset = (position - middle) * view_.devicePixelRatioF();
    return {offset.x(), -offset.y()};
  }

private:
  const QWidget& view_;
  const Scene3d& scene_;
};

} // namespace dewpoint::ui
