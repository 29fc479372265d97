// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/timeline_veils.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {

constexpr float kForgottenVeil = 0.6F;
constexpr float kOldVeil = 0.72F;
constexpr float kHatching = 0.35F;
constexpr double kHatchSpacing = 7.0; ///< pixels between the lines, wider than any ribbon's pattern

QColor withAlpha(QColor color, float alpha) {
  color.setAlphaF(alpha);
  return color;
}

void hatch(QPainter& painter, const QRectF& area) {
  painter.save();
  painter.setClipRect(area, Qt::IntersectClip);
  // Lines of all ribbons continue each other: they belong to the widget.
  const double reach = area.right() + area.bottom();
  double at = kHatchSpacing * std::floor((area.left() + area.top()) / kHatchSpacing);
  for (; at < reach; at += kHatchSpacing) {
    painter.drawLine(QPointF(at - area.top(), area.top()),
                     QPointF(at - area.bottom(), area.bottom()));
  }
  painter.restore();
}

} // namespace

void paintForgottenFrames(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                          const TimelineRows& rows, const QPalette& palette) {
  if (model.history.firstFrame <= scale.firstFrame()) {
    return;
  }
  QRectF gone = rows.ribbonsArea.united(rows.camerasArea);
  gone.setRight(std::clamp(scale.xOf(static_cast<double>(model.history.firstFrame)), gone.left(),
                           gone.right()));
  painter.fillRect(gone, withAlpha(palette.color(QPalette::Window), kForgottenVeil));
}

void paintOldResults(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                     const TimelineRows& rows, const QPalette& palette) {
  painter.setPen(QPen(withAlpha(palette.color(QPalette::Text), kHatching), 1.0));
  for (const ResultRange& range : model.oldResults) {
    const double begin =
        std::max(rows.ribbonsArea.left(), scale.xOf(static_cast<double>(range.firstFrame)));
    const double end =
        std::min(rows.ribbonsArea.right(), scale.xOf(static_cast<double>(range.lastFrame) + 1.0));
    for (int k = 0; k < model.targetNames.size() && begin < end; ++k) {
      const QRectF ribbon = rows.ribbonArea(k);
      const QRectF area(begin, ribbon.top(), end - begin, ribbon.height());
      painter.fillRect(area, withAlpha(palette.color(QPalette::Base), kOldVeil));
      hatch(painter, area);
    }
  }
}

} // namespace dewpoint::ui
