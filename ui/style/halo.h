// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QColor>
#include <QPainter>
#include <QPen>

namespace dewpoint::ui {

/// Dark line drawn under a bright line, so that the bright line is visible on any image.
struct Halo {
  int alpha = 150;
  double extraWidthPx = 2.2;             ///< additional width compared with the bright line, pixels
  bool isAlwaysSolid = false;            ///< solid, even under a dashed line
  Qt::PenCapStyle cap = Qt::RoundCap;    ///< ends of the halo and of the bright line
  Qt::PenJoinStyle join = Qt::RoundJoin; ///< corners of the halo and of the bright line
};
/// Halo under the lines of grids and boards, which lie close together.
inline constexpr Halo kGridHalo{170, 2.0};

/// Returns the halo for frames, crosses and handles: a solid line without rounded corners, with
/// this opacity (0 to 255), `extra` pixels wider than the bright line.
constexpr Halo edgeHalo(int alpha, double extra) {
  return {alpha, extra, true, Qt::SquareCap, Qt::BevelJoin};
}

/// Returns the pen for the halo under a line of this width (pixels).
inline QPen haloPen(double width, const Halo& halo = {}, Qt::PenStyle style = Qt::SolidLine) {
  return QPen(QColor(0, 0, 0, halo.alpha), width + halo.extraWidthPx,
              halo.isAlwaysSolid ? Qt::SolidLine : style, halo.cap, halo.join);
}

/// Calls `draw` twice: first with the pen of the halo, then with the pen of the bright line.
template <class Draw>
void drawWithHalo(QPainter& painter, const QColor& color, double width, const Draw& draw,
                  Qt::PenStyle style = Qt::SolidLine, const Halo& halo = {}) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(haloPen(width, halo, style));
  draw();
  painter.setPen(QPen(color, width, style, halo.cap, halo.join));
  draw();
}

} // namespace dewpoint::ui
