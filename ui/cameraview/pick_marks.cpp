// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/pick_marks.h"

#include "ui/style/halo.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QRectF>

#include <algorithm>

namespace dewpoint::ui {

namespace {

constexpr double kPickArm = 14.0; ///< of the cross, widget units

constexpr QColor kPickColor(0xf0, 0xe4, 0x42);

} // namespace

void paintPickOutline(QPainter& painter, const QPolygonF& outline, Qt::PenStyle style) {
  drawWithHalo(
      painter, kPickColor, 1.4, [&] { painter.drawPolygon(outline); }, style, edgeHalo(170, 1.6));
}

void paintPickRegion(QPainter& painter, const QPolygonF& outline, const QString& text,
                     const QSizeF& room) {
  paintPickOutline(painter, outline, Qt::SolidLine);
  if (text.isEmpty()) {
    return;
  }
  const QRectF box = outline.boundingRect();
  constexpr int kAround = 4;
  constexpr int kFlags = static_cast<int>(Qt::AlignCenter) | static_cast<int>(Qt::TextWordWrap);
  const QRect most(0, 0, std::max(1, static_cast<int>(room.width()) - 2 * kAround), 1000);
  const QRectF words = painter.fontMetrics()
                           .boundingRect(most, kFlags, text)
                           .toRectF()
                           .adjusted(-kAround, -2, kAround, 2);
  QRectF label(box.topLeft() - QPointF(0.0, words.height() + 2.0), words.size());
  label.moveLeft(std::clamp(label.left(), 0.0, std::max(0.0, room.width() - label.width())));
  label.moveTop(std::max(0.0, label.top()));
  painter.fillRect(label, QColor(0, 0, 0, 170));
  painter.setPen(kPickColor);
  painter.drawText(label, kFlags, text);
}

void paintPickCross(QPainter& painter, const QPointF& position) {
  for (const QPointF arm : {QPointF(kPickArm, 0.0), QPointF(0.0, kPickArm)}) {
    paintPickOutline(painter, QPolygonF({position - arm, position - 0.3 * arm}), Qt::SolidLine);
    paintPickOutline(painter, QPolygonF({position + 0.3 * arm, position + arm}), Qt::SolidLine);
  }
}

void paintPickGuide(QPainter& painter, const QPolygonF& line) {
  drawWithHalo(painter, kPickColor, 1.2, [&] { painter.drawPolyline(line); });
}

QStringList pickHintLines(const QString& hint, const QFontMetricsF& metrics, double width) {
  const QString between = QStringLiteral(" · ");
  QStringList lines;
  for (const QString& part : hint.split(between)) {
    const QString longer = lines.isEmpty() ? part : lines.last() + between + part;
    if (!lines.isEmpty() && metrics.horizontalAdvance(longer) <= width) {
      lines.last() = longer;
    } else {
      lines << part;
    }
  }
  return lines;
}

void paintPickHint(QPainter& painter, const QString& hint, const QRectF& area) {
  constexpr double kBeside = 24.0; ///< of the text, at both sides together
  const QFontMetricsF metrics(painter.font());
  const QStringList lines = pickHintLines(hint, metrics, area.width() - kBeside);
  double width = 0.0;
  for (const QString& line : lines) {
    width = std::max(width, metrics.horizontalAdvance(line));
  }
  const double height = metrics.height() * static_cast<double>(lines.size());
  const QSizeF pill(width + kBeside, height + 10.0);
  const QRectF place(
      QPointF(area.center().x() - pill.width() / 2.0, area.bottom() - pill.height() - 10.0), pill);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 190));
  const double corner = (metrics.height() + 10.0) / 2.0;
  painter.drawRoundedRect(place, corner, corner);
  painter.setPen(Qt::white);
  painter.drawText(place, Qt::AlignCenter, lines.join(QLatin1Char('\n')));
}

} // namespace dewpoint::ui
