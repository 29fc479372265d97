// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPointF>
#include <QRectF>
#include <QSize>

namespace dewpoint::ui {

/// Placement of an image in its widget: upper left corner in widget coordinates, and widget
/// units per image pixel. Pixel centers lie at integer coordinates.
struct ImagePlacement {
  QPointF topLeft;
  double scale = 1.0;

  QPointF positionOf(const QPointF& pixel) const {
    return topLeft + (pixel + QPointF(0.5, 0.5)) * scale;
  }
  QPointF pixelAt(const QPointF& position) const {
    return (position - topLeft) / scale - QPointF(0.5, 0.5);
  }
  /// Returns the area covered by an image of this size, in widget coordinates.
  QRectF areaOf(const QSize& image) const { return {topLeft, QSizeF(image) * scale}; }
};

} // namespace dewpoint::ui
