// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPointF>
#include <QRectF>
#include <QSize>

namespace dewpoint::ui {

/// Where an image lies in its widget: its upper left corner, and widget units per image pixel.
/// Centers of pixels lie at whole numbers.
struct ImagePlacement {
  QPointF corner;
  double scale = 1.0;

  QPointF positionOf(const QPointF& pixel) const {
    return corner + (pixel + QPointF(0.5, 0.5)) * scale;
  }
  QPointF pixelAt(const QPointF& position) const {
    return (position - corner) / scale - QPointF(0.5, 0.5);
  }
  /// All of an image of this size, widget units.
  QRectF areaOf(const QSize& image) const { return {corner, QSizeF(image) * scale}; }
};

} // namespace dewpoint::ui
