// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_cursor.h"

#include <algorithm>

namespace dewpoint::ui {

void PlotCursor::applyDefaultAntialiasingHint(QCPPainter* painter) const {
  painter->setAntialiasing(false);
}

void PlotCursor::draw(QCPPainter* painter) {
  const QPalette& palette = mParentPlot->palette();
  const auto fill = [&](const QCPAxisRect& rect, const std::pair<double, double>& part,
                        const QColor& color, int alpha) {
    const QCPAxis* axis = rect.axis(QCPAxis::atBottom);
    // A range of one frame is still seen.
    const double left = axis->coordToPixel(part.first);
    const double right = std::max(left + 2.0, axis->coordToPixel(part.second));
    QColor faint = color;
    faint.setAlpha(alpha);
    painter->fillRect(QRectF(QPointF(left, rect.top()), QPointF(right, rect.bottom())), faint);
    painter->setPen(QPen(color, 0.0));
    for (const double edge : {left, right}) {
      painter->drawLine(QPointF(edge, rect.top()), QPointF(edge, rect.bottom()));
    }
  };
  const auto line = [&](const QCPAxisRect& rect, double place, const QPen& pen) {
    const double x = rect.axis(QCPAxis::atBottom)->coordToPixel(place);
    painter->setPen(pen);
    painter->drawLine(QPointF(x, rect.top()), QPointF(x, rect.bottom()));
  };
  const QColor accent = palette.color(QPalette::Highlight);
  for (const QCPAxisRect* rect : axisRects) {
    painter->setClipRect(rect->rect());
    if (selectedRange) {
      fill(*rect, *selectedRange, accent, 48);
    }
    if (draggedRange) {
      fill(*rect, *draggedRange, palette.color(QPalette::WindowText), 32);
    }
    if (currentPosition) {
      line(*rect, *currentPosition, QPen(accent, 2.0));
    }
    if (hoveredPosition) {
      line(*rect, *hoveredPosition, QPen(palette.color(QPalette::WindowText), 0.0));
    }
  }
}

} // namespace dewpoint::ui
