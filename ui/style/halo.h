// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QColor>
#include <QPainter>
#include <QPen>

namespace dewpoint::ui {

/// Strokes twice, so that it reads on any image: a wide dark line, then the bright one.
template <class Draw>
void withHalo(QPainter& painter, const QColor& color, double width, const Draw& draw,
              Qt::PenStyle style = Qt::SolidLine) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 150), width + 2.2, style, Qt::RoundCap, Qt::RoundJoin));
  draw();
  painter.setPen(QPen(color, width, style, Qt::RoundCap, Qt::RoundJoin));
  draw();
}

} // namespace dewpoint::ui
