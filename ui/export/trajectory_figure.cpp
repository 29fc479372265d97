// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/trajectory_figure.h"

#include "core/base/text_file.h"
#include "core/trajectory/trajectory_figure.h"
#include "ui/style/theme.h"
#include "ui/text/quantity_text.h"

#include <QBuffer>
#include <QPageSize>
#include <QPainter>
#include <QPainterPath>
#include <QPdfWriter>
#include <QSvgGenerator>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dewpoint::ui {

namespace {

constexpr double kFigureWidth = 1000.0; ///< of the page in the units drawn with; A4 is 1.414 : 1
constexpr double kHeight = 707.0;
constexpr double kFigureMargin = 24.0;
constexpr double kAxisSpace = 58.0; ///< for the numbers beside an axis
const QColor kInk(40, 40, 40);
const QColor kGrid(222, 222, 222);

/// A frame with axes, into which curves are drawn.
class Panel {
public:
  Panel(QPainter& painter, QRectF frame, const FigurePanel& shown)
      : painter_(painter), frame_(frame), horizontal_(shown.horizontal), vertical_(shown.vertical) {
  }

  void drawAxes(const QString& horizontalName, const QString& verticalName, bool numbersBelow) {
    for (const double x : gridLines(horizontal_)) {
      const QPointF foot = at(x, vertical_.low);
      line(foot, {foot.x(), frame_.top()}, kGrid);
      if (numbersBelow) {
        text(QRectF(foot.x() - 40, foot.y() + 3, 80, 16), Qt::AlignHCenter, figureNumberText(x));
      }
    }
    for (const double y : gridLines(vertical_)) {
      const QPointF foot = at(horizontal_.low, y);
      line(foot, {frame_.right(), foot.y()}, kGrid);
      text(QRectF(foot.x() - 56, foot.y() - 8, 50, 16), Qt::AlignRight | Qt::AlignVCenter,
           figureNumberText(y));
    }
    painter_.setPen(QPen(kInk, 1.0));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawRect(frame_);
    if (numbersBelow) {
      text(QRectF(frame_.left(), frame_.bottom() + 18, frame_.width(), 18), Qt::AlignHCenter,
           horizontalName);
    }
    text(QRectF(frame_.left() + 6, frame_.top() + 3, frame_.width(), 18), Qt::AlignLeft,
         verticalName);
  }

  void drawCurve(const FigureCurve& curve, const QColor& color) {
    painter_.save();
    painter_.setClipRect(frame_);
    if (!curve.band.empty()) {
      QColor veil = color;
      veil.setAlphaF(0.2F);
      painter_.setPen(Qt::NoPen);
      painter_.setBrush(veil);
      painter_.drawPolygon(placed(curve.band));
    }
    QPainterPath path;
    path.addPolygon(placed(curve.path));
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(color, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter_.drawPath(path);
    painter_.restore();
  }

private:
  QPointF at(double x, double y) const {
    return {frame_.left() + (x - horizontal_.low) / horizontal_.size() * frame_.width(),
            frame_.bottom() - (y - vertical_.low) / vertical_.size() * frame_.height()};
  }
  QPolygonF placed(const std::vector<Eigen::Vector2d>& points) const {
    QPolygonF polygon;
    for (const Eigen::Vector2d& point : points) {
      polygon << at(point.x(), point.y());
    }
    return polygon;
  }
  void line(QPointF from, QPointF to, const QColor& color) {
    painter_.setPen(QPen(color, 0.8));
    painter_.drawLine(from, to);
  }
  void text(const QRectF& box, int flags, const QString& words) {
    painter_.setPen(kInk);
    painter_.drawText(box, flags | Qt::TextDontClip, words);
  }

  QPainter& painter_;
  QRectF frame_;
  AxisRange horizontal_;
  AxisRange vertical_;
};

/// The dark twin of a target's color, which reads on white.
QColor inkOf(const ExportTable& table, std::size_t target) {
  return targetColor(table.targets[target], static_cast<int>(target)).darker(115);
}

void drawCurves(Panel& panel, const FigurePanel& shown, const ExportTable& table) {
  for (const FigureCurve& curve : shown.curves) {
    panel.drawCurve(curve, inkOf(table, curve.target));
  }
}

void drawLegend(QPainter& painter, const ExportTable& table, QRectF place) {
  for (std::size_t target = 0; target < table.targets.size(); ++target) {
    painter.fillRect(QRectF(place.left(), place.top() + 5, 14, 4), inkOf(table, target));
    painter.setPen(kInk);
    painter.drawText(QRectF(place.left() + 20, place.top() - 2, place.width() - 20, 18),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     QString::fromStdString(table.targets[target]));
    place.translate(0, 18);
  }
}

constexpr const char* kAxisNames[] = {"x", "y", "z"};

QString axisName(const ExportTable& table, int axis) {
  return QStringLiteral("%1 (%2)").arg(QLatin1String(kAxisNames[axis]),
                                       QLatin1String(table.unitName()));
}

} // namespace

void drawTrajectoryFigure(QPainter& painter, const QRectF& page, const ExportTable& table,
                          const FigureWords& words) {
  painter.save();
  painter.translate(page.topLeft());
  const double scale = std::min(page.width() / kFigureWidth, page.height() / kHeight);
  painter.scale(scale, scale);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(QRectF(0, 0, kFigureWidth, kHeight), Qt::white);
  QFont font(QStringLiteral("sans-serif"));
  font.setPixelSize(13);
  painter.setFont(font);
  painter.setPen(kInk);
  painter.drawText(QRectF(kFigureMargin, 12, kFigureWidth - 2 * kFigureMargin, 20), Qt::AlignLeft,
                   words.title);

  const TrajectoryFigure figure = trajectoryFigure(table);
  const double top = 44.0;
  const double height = (kHeight - top - 60.0) / 3.0;
  for (std::size_t axis = 0; axis < figure.overTime.size(); ++axis) {
    const FigurePanel& shown = figure.overTime[axis];
    Panel panel(painter,
                QRectF(kFigureMargin + kAxisSpace, top + static_cast<double>(axis) * height, 470.0,
                       height - 10.0),
                shown);
    panel.drawAxes(words.time, axisName(table, shown.verticalAxis), axis == 2);
    drawCurves(panel, shown, table);
  }
  const QRectF square(660.0, top, kFigureWidth - 660.0 - kFigureMargin,
                      kFigureWidth - 660.0 - kFigureMargin);
  Panel above(painter, square, figure.fromAbove);
  above.drawAxes(
      axisName(table, figure.fromAbove.horizontalAxis),
      words.topView + QStringLiteral(", ") + axisName(table, figure.fromAbove.verticalAxis), true);
  drawCurves(above, figure.fromAbove, table);
  drawLegend(painter, table, QRectF(square.left(), square.bottom() + 54.0, square.width(), 18.0));
  painter.restore();
}

Status writeTrajectoryFigure(const ExportTable& table, const FigureWords& words,
                             const std::filesystem::path& file) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  const QRectF page(0, 0, kFigureWidth, kHeight);
  if (file.extension() == ".pdf") {
    QPdfWriter device(&buffer);
    device.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Landscape, {}));
    device.setTitle(words.title);
    QPainter painter(&device);
    drawTrajectoryFigure(painter, QRectF(0, 0, device.width(), device.height()), table, words);
  } else {
    QSvgGenerator device;
    device.setOutputDevice(&buffer);
    device.setSize(page.size().toSize());
    device.setViewBox(page);
    device.setTitle(words.title);
    QPainter painter(&device);
    drawTrajectoryFigure(painter, page, table, words);
  }
  return writeTextFile(file, buffer.data().toStdString());
}

} // namespace dewpoint::ui
