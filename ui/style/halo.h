// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QColor>
#include <QPainter>
#include <QPen>

namespace dewpoint::ui {

/// The dark line under a bright stroke, so that it reads on any image.
struct Halo {
  int alpha = 150;
  double extra = 2.2; ///< wider than the stroke, pixels
};
/// Under the lines of grids and boards, of which there are many side by side.
inline constexpr Halo kGridHalo{170, 2.0};

/// The pen of the halo under a stroke of this width.
inline QPen haloPen(double width, const Halo& halo = {}, Qt::PenStyle style = Qt::SolidLine) {
  return QPen(QColor(0, 0, 0, halo.alpha), width + halo.extra, style, Qt::RoundCap, Qt::RoundJoin);
}

/// Strokes twice: the halo, then the bright line.
template <class Draw>
void withHalo(QPainter& painter, const QColor& color, double width, const Draw& draw,
              Qt::PenStyle style = Qt::SolidLine, const Halo& halo = {}) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(haloPen(width, halo, style));
  draw();
  painter.setPen(QPen(color, width, style, Qt::RoundCap, Qt::RoundJoin));
  draw();
}

} // namespace dewpoint::ui
