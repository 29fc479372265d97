// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/trajectory_figure.h"

#include "core/base/overloaded.h"
#include "core/base/text_file.h"
#include "ui/style/theme.h"

#include <QBuffer>
#include <QPageSize>
#include <QPainter>
#include <QPainterPath>
#include <QPdfWriter>
#include <QSvgGenerator>

#include <algorithm>
#include <vector>

namespace dewpoint::ui {

namespace {

const QColor kInk(40, 40, 40);
const QColor kGrid(222, 222, 222);

/// The dark twin of a target's color, which reads on white.
QColor inkOf(const ExportTable& table, std::size_t target) {
  return targetColor(table.targets[target], static_cast<int>(target)).darker(115);
}

QRectF rectangle(const Eigen::AlignedBox2d& box) {
  return {box.min().x(), box.min().y(), box.sizes().x(), box.sizes().y()};
}

QPolygonF polygon(const std::vector<Eigen::Vector2d>& points) {
  QPolygonF polygon;
  for (const Eigen::Vector2d& point : points) {
    polygon << QPointF(point.x(), point.y());
  }
  return polygon;
}

void drawLabel(QPainter& painter, const FigureDrawing::Label& label) {
  using Align = FigureDrawing::Align;
  const int across = label.alignment == Align::Left    ? Qt::AlignLeft
                     : label.alignment == Align::Right ? Qt::AlignRight
                                                       : Qt::AlignHCenter;
  const int down = label.isCentered ? Qt::AlignVCenter : Qt::AlignTop;
  painter.setPen(kInk);
  painter.drawText(rectangle(label.box), across | down | Qt::TextDontClip,
                   QString::fromStdString(label.text));
}

void drawCurve(QPainter& painter, const FigureDrawing::Curve& curve, const QColor& color) {
  painter.save();
  painter.setClipRect(rectangle(curve.clipRectangle));
  if (!curve.uncertaintyBand.empty()) {
    QColor veil = color;
    veil.setAlphaF(0.2F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(veil);
    painter.drawPolygon(polygon(curve.uncertaintyBand));
  }
  QPainterPath path;
  path.addPolygon(polygon(curve.path));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(color, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
  painter.restore();
}

void drawItem(QPainter& painter, const ExportTable& table, const FigureDrawing::Item& item) {
  std::visit(Overloaded{[&](const FigureDrawing::GridLine& line) {
                          painter.setPen(QPen(kGrid, 0.8));
                          painter.drawLine(QPointF(line.from.x(), line.from.y()),
                                           QPointF(line.to.x(), line.to.y()));
                        },
                        [&](const FigureDrawing::PlotFrame& frame) {
                          painter.setPen(QPen(kInk, 1.0));
                          painter.setBrush(Qt::NoBrush);
                          painter.drawRect(rectangle(frame.box));
                        },
                        [&](const FigureDrawing::Label& label) { drawLabel(painter, label); },
                        [&](const FigureDrawing::Curve& curve) {
                          drawCurve(painter, curve, inkOf(table, curve.target));
                        },
                        [&](const FigureDrawing::LegendKey& key) {
                          painter.fillRect(rectangle(key.box), inkOf(table, key.target));
                        }},
             item);
}

} // namespace

void drawTrajectoryFigure(QPainter& painter, const QRectF& page, const ExportTable& table,
                          const FigureTexts& texts) {
  const QRectF whole(0, 0, FigureDrawing::kWidth, FigureDrawing::kHeight);
  painter.save();
  painter.translate(page.topLeft());
  const double scale = std::min(page.width() / whole.width(), page.height() / whole.height());
  painter.scale(scale, scale);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(whole, Qt::white);
  QFont font(QStringLiteral("sans-serif"));
  font.setPixelSize(static_cast<int>(FigureDrawing::kFontSize));
  painter.setFont(font);
  const FigureDrawing drawing = layOutFigure(table, texts);
  for (const FigureDrawing::Item& item : drawing.items) {
    drawItem(painter, table, item);
  }
  painter.restore();
}

Status writeTrajectoryFigure(const ExportTable& table, const FigureTexts& texts,
                             const std::filesystem::path& file) {
  const QString title = QString::fromStdString(texts.title);
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  if (file.extension() == ".pdf") {
    QPdfWriter device(&buffer);
    device.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Landscape, {}));
    device.setTitle(title);
    QPainter painter(&device);
    drawTrajectoryFigure(painter, QRectF(0, 0, device.width(), device.height()), table, texts);
  } else {
    const QRectF page(0, 0, FigureDrawing::kWidth, FigureDrawing::kHeight);
    QSvgGenerator device;
    device.setOutputDevice(&buffer);
    device.setSize(page.size().toSize());
    device.setViewBox(page);
    device.setTitle(title);
    QPainter painter(&device);
    drawTrajectoryFigure(painter, page, table, texts);
  }
  return writeTextFile(file, buffer.data().toStdString());
}

} // namespace dewpoint::ui
