// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/timeline_painter.h"

#include "ui/style/target_colors.h"
#include "ui/style/theme.h"
#include "ui/text/quantity_text.h"
#include "ui/text/reason_text.h"
#include "ui/timeline/correction_marks.h"
#include "ui/timeline/timeline_ribbon.h"
#include "ui/timeline/timeline_veils.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::ui {

namespace {

constexpr double kGap = 3.0;
/// From a line of the axis to its label: beside the sign of the current frame, which is this wide.
constexpr double kLabelGap = 8.0;
constexpr double kHeadReach = 6.0; ///< of that sign, to either side
constexpr int kMostRowsWanted = 5;

void paintDropouts(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                   const QRectF& row, std::size_t camera, const QPalette& palette) {
  painter.fillRect(row, palette.color(QPalette::Base));
  const QColor color = trackingStateColor(TrackingState::Missing, palette);
  for (std::size_t k = 0; k < model.records.size(); ++k) {
    const FrameRecord& record = model.records[k];
    if ((record.missingCameraBits >> camera & 1U) != 0) {
      const double begin = scale.xOf(static_cast<double>(record.frame));
      const double end = scale.xOf(static_cast<double>(record.frame) + 1.0);
      if (end >= row.left() && begin <= row.right()) {
        painter.fillRect(QRectF(std::max(begin, row.left()), row.top(),
                                std::max(1.5, std::min(end, row.right()) - begin), row.height()),
                         color);
      }
    }
  }
}

/// The smallest round step (1, 2, 5 times a power of ten seconds, or whole minutes) that leaves
/// `room` pixels between labels.
double roundStep(double pixelsPerSecond, double room) {
  static constexpr std::array kSteps{0.01, 0.02, 0.05, 0.1, 0.2,  0.5,  1.0,   2.0,   5.0,
                                     10.0, 15.0, 30.0, 60., 120., 300., 600.0, 1800., 3600.};
  for (const double step : kSteps) {
    if (step * pixelsPerSecond >= room) {
      return step;
    }
  }
  return kSteps.back();
}

/// A label of the axis, with the decimals that labels `step` seconds apart need.
QString clock(double seconds, double step) {
  return minutesAndSecondsText(seconds, ClockForm::Axis, step < 0.1 ? 2 : step < 1.0 ? 1 : 0);
}

void paintAxis(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
               const TimelineRows& rows, const QPalette& palette) {
  const double origin = model.secondsOf(scale.firstFrame());
  const double perSecond = scale.pixelsPerFrame() * model.framesPerSecond;
  const QFontMetricsF metrics(painter.font());
  const double step =
      roundStep(perSecond, metrics.horizontalAdvance(QStringLiteral("00:00.00")) + 24);
  const double left = scale.xOf(static_cast<double>(scale.firstFrame()));
  QColor line = palette.color(QPalette::Mid);
  for (double k = std::ceil(origin / step);; ++k) {
    const double at = k * step; // no sum: errors would make 59.999 s of a minute
    const double x = left + (at - origin) * perSecond;
    if (x > rows.axisArea.right() + 0.5) { // the end itself has its label
      break;
    }
    if (x >= rows.axisArea.left() - 1.0) {
      painter.setPen(line);
      painter.drawLine(QPointF(x, rows.axisArea.bottom() - 5), QPointF(x, rows.axisArea.bottom()));
      painter.setPen(palette.color(QPalette::PlaceholderText));
      const QString text = clock(at, step);
      const double width = metrics.horizontalAdvance(text);
      const bool fits = x + kLabelGap + width <= rows.axisArea.right() + 7.0;
      painter.drawText(
          QPointF(fits ? x + kLabelGap : x - kLabelGap - width, rows.axisArea.bottom() - 5.0),
          text);
    }
  }
}

void paintMarkers(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                  const TimelineRows& rows, const QPalette& palette) {
  const QFontMetricsF metrics(painter.font());
  const QColor color = palette.color(QPalette::Text);
  for (const ProjectMarker& marker : model.markers) {
    const QRectF flag = markerFlagArea(marker, scale, rows, metrics);
    if (flag.right() < rows.axisArea.left() || flag.left() > rows.axisArea.right()) {
      continue;
    }
    const double x = flag.left();
    painter.setPen(QPen(color, 1.2));
    painter.drawLine(QPointF(x, flag.top()), QPointF(x, rows.camerasArea.bottom()));
    QPainterPath path(flag.topLeft());
    path.lineTo(flag.right() - 5.0, flag.top());
    path.lineTo(flag.right(), flag.center().y());
    path.lineTo(flag.right() - 5.0, flag.bottom());
    path.lineTo(flag.left(), flag.bottom());
    path.closeSubpath();
    painter.fillPath(path, palette.color(QPalette::ToolTipBase));
    painter.drawPath(path);
    painter.setPen(palette.color(QPalette::ToolTipText));
    painter.drawText(flag.adjusted(4, 0, -6, 0), Qt::AlignVCenter | Qt::AlignLeft,
                     QString::fromStdString(marker.name));
  }
}

void paintHead(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
               const TimelineRows& rows, const Selection& selection, const QPalette& palette) {
  const QRectF body = rows.ribbonsArea.united(rows.camerasArea);
  if (selection.isAwayFromLiveFrame() &&
      model.history.newestTrackedFrame >= 0) { // where the run stands meanwhile
    const double x = scale.xOf(static_cast<double>(model.history.newestTrackedFrame) + 0.5);
    painter.setPen(QPen(palette.color(QPalette::Text), 1.2, Qt::DashLine));
    painter.drawLine(QPointF(x, rows.axisArea.bottom()), QPointF(x, body.bottom()));
  }
  if (selection.currentFrame() < 0) {
    return;
  }
  const double x = scale.xOf(static_cast<double>(selection.currentFrame()) + 0.5);
  if (x < rows.axisArea.left() - 1.0 || x > rows.axisArea.right() + 1.0) {
    return;
  }
  painter.setPen(QPen(palette.color(QPalette::Base), 4.0));
  painter.drawLine(QPointF(x, rows.axisArea.bottom()), QPointF(x, body.bottom()));
  const QColor color = palette.color(QPalette::Highlight);
  painter.setPen(QPen(color, 2.0));
  painter.drawLine(QPointF(x, rows.axisArea.bottom() - 2.0), QPointF(x, body.bottom()));
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  const double y = rows.axisArea.bottom();
  painter.drawPolygon(QPolygonF(
      {QPointF(x - kHeadReach, y - 8.0), QPointF(x + kHeadReach, y - 8.0), QPointF(x, y + 1.0)}));
}

void paintHovered(QPainter& painter, const TimelineScale& scale, const TimelineRows& rows,
                  qint64 frame, const QPalette& palette) {
  const double x = scale.xOf(static_cast<double>(frame) + 0.5);
  if (frame < 0 || x < rows.axisArea.left() || x > rows.axisArea.right()) {
    return;
  }
  // Dark on a bright rim: seen on the ribbons as well as beside them.
  const QLineF line(x, rows.axisArea.top(), x, rows.camerasArea.bottom());
  painter.setPen(QPen(palette.color(QPalette::Base), 3.0));
  painter.drawLine(line);
  painter.setPen(QPen(palette.color(QPalette::WindowText), 1.0));
  painter.drawLine(line);
}

void paintSelectedRange(QPainter& painter, const TimelineScale& scale, const TimelineRows& rows,
                        const Selection& selection, const QPalette& palette) {
  if (!selection.selectedRange()) {
    return;
  }
  const double begin = scale.xOf(static_cast<double>(selection.selectedRange()->first));
  const double end = scale.xOf(static_cast<double>(selection.selectedRange()->last) + 1.0);
  QColor color = palette.color(QPalette::Highlight);
  painter.setPen(QPen(color, 1.2));
  color.setAlphaF(0.22F);
  const QRectF area(begin, rows.axisArea.top(), end - begin,
                    rows.camerasArea.bottom() - rows.axisArea.top());
  painter.fillRect(area, color);
  painter.drawLine(area.topLeft(), area.bottomLeft());
  painter.drawLine(area.topRight(), area.bottomRight());
}

void paintNames(QPainter& painter, const TimelineModel& model, const TimelineRows& rows,
                const QPalette& palette) {
  const QFontMetricsF metrics(painter.font());
  const double room = rows.axisArea.left() - 14.0;
  const auto write = [&](const QRectF& row, const QString& name, const QColor& color) {
    painter.setPen(color);
    painter.drawText(QRectF(8.0, row.center().y() - metrics.height() / 2.0, room, metrics.height()),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(name, Qt::ElideRight, room));
  };
  const std::vector<QColor> colors = targetColors(model.colorSources, displayBackgroundOf(palette));
  for (int k = 0; k < model.targetNames.size(); ++k) {
    const QRectF row = rows.ribbonArea(k);
    if (rows.ribbonHeight >= 0.8 * metrics.height()) { // else names would lie on one another
      write(row, model.targetNames[k], palette.color(QPalette::WindowText));
    }
    if (const auto target = static_cast<std::size_t>(k); target < colors.size()) {
      const double half = std::min(4.0, 0.5 * row.height());
      painter.fillRect(QRectF(1.0, row.center().y() - half, 4.0, 2.0 * half), colors[target]);
    }
  }
  if (rows.camerasShareRow) {
    write(rows.camerasArea, QCoreApplication::translate("Timeline", "✕ no image"),
          palette.color(QPalette::PlaceholderText));
    return;
  }
  int row = 0;
  for (int k = 0; k < model.cameraNames.size(); ++k) {
    if (model.hasDropouts(static_cast<std::size_t>(k))) {
      write(rows.cameraRowArea(row++),
            QCoreApplication::translate("Timeline", "✕ %1").arg(model.cameraNames[k]),
            palette.color(QPalette::PlaceholderText));
    }
  }
}

/// Writes which frames are tracked again.
void paintFooter(QPainter& painter, const TimelineModel& model, const TimelineRows& rows,
                 const QPalette& palette) {
  if (!model.rerun) {
    return;
  }
  const QString text =
      QCoreApplication::translate("Timeline", "tracking frames %2 to %3 again: now at %1")
          .arg(frameNumberText(model.history.newestTrackedFrame))
          .arg(frameNumberText(model.rerun->firstFrame))
          .arg(frameNumberText(model.rerun->lastFrame));
  painter.setPen(palette.color(QPalette::PlaceholderText));
  painter.drawText(rows.footerArea, Qt::AlignRight | Qt::AlignVCenter, text);
}

} // namespace

TimelineRows::TimelineRows(const QSizeF& size, int targetCount, int cameraCount, double fontHeight,
                           double gutter, bool hasFooter) {
  const double width = size.width() - gutter - 10.0;
  const double axisHeight = fontHeight + 8.0;
  const double footerHeight = hasFooter ? fontHeight + 4.0 : 0.0;
  const double body = std::max(20.0, size.height() - axisHeight - footerHeight - 2.0 * kGap);
  const double readable = std::max(1, targetCount) * (fontHeight + kGap);
  camerasShareRow = cameraCount > 1 && body - cameraCount * fontHeight < readable;
  cameraRowHeight = camerasShareRow ? fontHeight / cameraCount : fontHeight;
  const double forRibbons = std::max(body - cameraCount * cameraRowHeight, 0.5 * body);
  ribbonHeight = std::clamp(forRibbons / std::max(1, targetCount), kGap + 2.0, 28.0);
  axisArea = QRectF(gutter, 0.0, width, axisHeight);
  ribbonsArea =
      QRectF(gutter, axisArea.bottom() + kGap, width, std::max(1, targetCount) * ribbonHeight);
  camerasArea = QRectF(gutter, ribbonsArea.bottom(), width, cameraCount * cameraRowHeight);
  footerArea = QRectF(gutter, size.height() - footerHeight, width, footerHeight);
}

int TimelineRows::minimumHeightFor(int targetCount, int cameraCount, double fontHeight) {
  const int ribbons = std::clamp(targetCount, 1, kMostRowsWanted);
  const double frame = 2.0 * fontHeight + 12.0 + 2.0 * kGap; // axis and footer
  return static_cast<int>(
      std::ceil(frame + ribbons * (fontHeight + kGap) + (cameraCount > 0 ? fontHeight : 0.0)));
}

QRectF TimelineRows::ribbonArea(int target) const {
  return {ribbonsArea.left(), ribbonsArea.top() + target * ribbonHeight, ribbonsArea.width(),
          ribbonHeight - kGap};
}

QRectF TimelineRows::cameraRowArea(int row) const {
  const double height =
      camerasShareRow ? std::max(1.0, cameraRowHeight - 1.0) : 0.5 * cameraRowHeight;
  const double top = camerasArea.top() + (row + 0.5) * cameraRowHeight - 0.5 * height;
  return {camerasArea.left(), top, camerasArea.width(), height};
}

QRectF markerFlagArea(const ProjectMarker& marker, const TimelineScale& scale,
                      const TimelineRows& rows, const QFontMetricsF& metrics) {
  const double x = scale.xOf(static_cast<double>(marker.frame) + 0.5);
  const double width = metrics.horizontalAdvance(QString::fromStdString(marker.name)) + 14.0;
  return {x, rows.axisArea.top() + 1.0, width, metrics.height() + 1.0};
}

void paintTimeline(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                   const TimelineRows& rows, const Selection& selection, qint64 hovered,
                   const QPalette& palette) {
  paintNames(painter, model, rows, palette);
  paintFooter(painter, model, rows, palette);
  painter.save();
  painter.setClipRect(rows.axisArea.united(rows.camerasArea).adjusted(-7, 0, 7, 2));
  paintAxis(painter, model, scale, rows, palette);
  for (int k = 0; k < model.targetNames.size(); ++k) {
    paintRibbon(painter, model, scale, rows.ribbonArea(k), static_cast<std::size_t>(k), palette);
  }
  if (model.targetNames.isEmpty() || model.records.empty()) {
    paintNothingTrackedText(painter, rows.ribbonsArea, palette);
  }
  int row = 0;
  for (int k = 0; k < model.cameraNames.size(); ++k) {
    const auto camera = static_cast<std::size_t>(k);
    if (model.hasDropouts(camera)) {
      paintDropouts(painter, model, scale, rows.cameraRowArea(row++), camera, palette);
    }
  }
  paintForgottenFrames(painter, model, scale, rows, palette);
  painter.setRenderHint(QPainter::Antialiasing);
  paintOldResults(painter, model, scale, rows, palette);
  paintSelectedRange(painter, scale, rows, selection, palette);
  paintCorrections(painter, model, scale, rows, palette);
  paintMarkers(painter, model, scale, rows, palette);
  paintHead(painter, model, scale, rows, selection, palette);
  paintHovered(painter, scale, rows, hovered, palette);
  painter.restore();
}

} // namespace dewpoint::ui
