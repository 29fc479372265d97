// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/manual/grid_painter.h"

#include "core/calibration/manual/click_aids.h"
#include "ui/calibration/manual/label_places.h"
#include "ui/style/halo.h"

#include <QImage>
#include <QPainter>
#include <QPolygonF>
#include <opencv2/core/mat.hpp>

#include <algorithm>
#include <functional>
#include <utility>

namespace dewpoint::ui {
namespace {

const QColor kPin("#f0e442");    // Okabe-Ito yellow
const QColor kPoint("#56b4e9");  // sky blue
const QColor kMisfit("#d55e00"); // vermilion

struct Stroke {
  QColor color;
  double width;
};

Stroke strokeOf(GridRole role) {
  switch (role) {
  case GridRole::Line:
    return {QColor("#9ff5ff"), 1.0};
  case GridRole::Border:
    return {QColor("#9ff5ff"), 1.7};
  case GridRole::AxisX:
    return {QColor("#ff7f50"), 2.2};
  case GridRole::AxisY:
    return {QColor("#5fe08a"), 2.2};
  case GridRole::AxisZ:
    return {QColor("#8ab4ff"), 2.2};
  }
  return {Qt::white, 1.0};
}

template <class Draw>
void withGridHalo(QPainter& painter, const QColor& color, double width, const Draw& draw) {
  drawWithHalo(painter, color, width, draw, Qt::SolidLine, kGridHalo);
}

QSizeF gridLabelSize(const QPainter& painter, const QString& text) {
  return painter.fontMetrics().boundingRect(text).toRectF().adjusted(-3, -1, 3, 1).size();
}

QRectF areaToPaint(const QPainter& painter) {
  const QRectF clip = painter.clipBoundingRect();
  return clip.isEmpty() ? QRectF(painter.viewport()) : clip;
}

void paintText(QPainter& painter, const QRectF& label, const QString& text, const QColor& color) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 150));
  painter.drawRoundedRect(label, 3.0, 3.0);
  painter.setPen(color);
  painter.drawText(label, Qt::AlignCenter, text);
}

/// Draws each segment of the lines alone. Qt divides the filling of longer lines among threads,
/// which takes ten times as long as filling them. Neighbors overlap, so the color must be opaque.
void drawSegments(QPainter& painter, const std::vector<QPolygonF>& lines,
                  const std::vector<GridStroke>& strokes,
                  const std::function<QPen(Stroke)>& penOf) {
  for (std::size_t k = 0; k < lines.size(); ++k) {
    painter.setPen(penOf(strokeOf(strokes[k].role)));
    for (qsizetype end = 1; end < lines[k].size(); ++end) {
      painter.drawLine(lines[k][end - 1], lines[k][end]);
    }
  }
}

/// Draws the lines in opaque colors into a layer, and the layer with this opacity.
void paintLayer(QPainter& painter, double opacity, const std::function<void(QPainter&)>& draw) {
  const QRect area = areaToPaint(painter).toAlignedRect();
  const double ratio = painter.device()->devicePixelRatioF();
  QImage layer(area.size() * ratio, QImage::Format_ARGB32_Premultiplied);
  layer.setDevicePixelRatio(ratio);
  layer.fill(Qt::transparent);
  {
    QPainter inLayer(&layer);
    inLayer.setRenderHint(QPainter::Antialiasing);
    inLayer.translate(-area.topLeft());
    draw(inLayer);
  }
  const double before = painter.opacity();
  painter.setOpacity(before * opacity);
  painter.drawImage(area.topLeft(), layer);
  painter.setOpacity(before);
}

/// All halos first: a bright line is never crossed by the dark of another.
void paintLines(QPainter& painter, const ProjectedGrid& grid, const std::vector<QPolygonF>& lines) {
  paintLayer(painter, kGridHalo.alpha / 255.0, [&](QPainter& layer) {
    drawSegments(layer, lines, grid.strokes, [](const Stroke& stroke) {
      return QPen(Qt::black, stroke.width + kGridHalo.extraWidthPx);
    });
  });
  paintLayer(painter, 1.0, [&](QPainter& layer) {
    drawSegments(layer, lines, grid.strokes,
                 [](const Stroke& stroke) { return QPen(stroke.color, stroke.width); });
  });
}

/// As many as have room; the names of the axes, which stand last, before all others. They point
/// away from the middle of the grid: its corners are what is aimed at.
void paintLabels(QPainter& painter, const ProjectedGrid& grid, const ImagePlacement& placement,
                 const std::vector<QPolygonF>& lines) {
  LabelPlacer places(areaToPaint(painter));
  QPointF sum;
  double count = 0.0;
  for (const QPolygonF& line : lines) {
    for (qsizetype k = 0; k < line.size(); ++k) {
      sum += line[k];
      count += 1.0;
      if (k > 0) {
        places.avoid({line[k - 1], line[k]});
      }
    }
  }
  const QPointF middle = sum / std::max(1.0, count);
  std::optional<GridRole> named;
  for (auto label = grid.labels.rbegin(); label != grid.labels.rend(); ++label) {
    const QString text = QString::fromStdString(label->text);
    const QPointF at = widgetPosition(label->at, placement);
    const QSizeF size = gridLabelSize(painter, text);
    const bool isName = std::exchange(named, label->role) != label->role;
    if (const auto place = isName ? places.reservePlaceOverLines(at, size, at - middle)
                                  : places.reservePlace(at, size, at - middle)) {
      paintText(painter, *place, text, strokeOf(label->role).color);
    }
  }
}

constexpr double kElsewhereOpacity = 0.35;

QColor pointColor(const PaintedPoint& point) {
  return point.isMisfit ? kMisfit : kPoint;
}

void paintPointMark(QPainter& painter, const PaintedPoint& point) {
  const QColor color = pointColor(point);
  const double width = point.isSelected ? 2.2 : 1.5;
  if (point.click && point.projection) {
    withGridHalo(painter, color, 1.0, [&] { painter.drawLine(*point.click, *point.projection); });
  }
  if (point.projection) {
    withGridHalo(painter, color, width, [&] { painter.drawEllipse(*point.projection, 6.0, 6.0); });
  }
  if (point.click) {
    withGridHalo(painter, color, width, [&] {
      painter.drawLine(*point.click + QPointF(-7, 0), *point.click + QPointF(7, 0));
      painter.drawLine(*point.click + QPointF(0, -7), *point.click + QPointF(0, 7));
    });
  }
}

void paintPointNames(QPainter& painter, const std::vector<PaintedPoint>& points) {
  const QPointF upRight(1.0, -1.0);
  LabelPlacer places(areaToPaint(painter));
  for (const PaintedPoint& point : points) {
    for (const auto& at : {point.click, point.projection}) {
      if (at && !point.isInOtherFrames) {
        places.avoid({*at + QPointF(-7, 0), *at + QPointF(7, 0)});
      }
    }
  }
  for (const PaintedPoint& point : points) {
    const auto& at = point.click ? point.click : point.projection;
    const QSizeF size = gridLabelSize(painter, point.name);
    const auto place = !at                     ? std::nullopt
                       : point.isInOtherFrames ? places.reservePlaceInDirection(*at, size, upRight)
                                               : places.reservePlaceOverLines(*at, size, upRight);
    if (place) {
      painter.setOpacity(point.isInOtherFrames ? kElsewhereOpacity : 1.0);
      paintText(painter, *place, point.name, pointColor(point));
    }
  }
}

} // namespace

QPointF widgetPosition(const Eigen::Vector2d& pixel, const ImagePlacement& placement) {
  return placement.topLeft + QPointF(pixel.x() + 0.5, pixel.y() + 0.5) * placement.scale;
}

void paintGrid(QPainter& painter, const ProjectedGrid& grid, const ImagePlacement& placement,
               double opacity) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(opacity);
  std::vector<QPolygonF> lines;
  for (const GridStroke& stroke : grid.strokes) {
    QPolygonF line;
    for (const Eigen::Vector2d& point : stroke.points) {
      line << widgetPosition(point, placement);
    }
    lines.push_back(std::move(line));
  }
  paintLines(painter, grid, lines);
  paintLabels(painter, grid, placement, lines);
  painter.restore();
}

void paintPin(QPainter& painter, QPointF place) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  withGridHalo(painter, kPin, 2.0, [&] {
    painter.drawEllipse(place, 5.0, 5.0);
    painter.drawLine(place + QPointF(0.0, -5.0), place + QPointF(0.0, -16.0));
    painter.drawLine(place + QPointF(-4.0, -16.0), place + QPointF(4.0, -16.0));
  });
  painter.restore();
}

void paintGrip(QPainter& painter, QPointF place) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  withGridHalo(painter, Qt::white, 1.6, [&] {
    painter.drawEllipse(place, 8.0, 8.0);
    painter.drawPoint(place);
  });
  painter.restore();
}

void paintPoints(QPainter& painter, const std::vector<PaintedPoint>& points) {
  // The most important last, to be on top, and first to get a place for its name.
  std::vector<PaintedPoint> ordered = points;
  std::ranges::stable_sort(ordered, {}, [](const PaintedPoint& point) {
    return point.isSelected ? 2 : point.isInOtherFrames ? 0 : 1;
  });
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const PaintedPoint& point : ordered) {
    painter.setOpacity(point.isInOtherFrames ? kElsewhereOpacity : 1.0);
    paintPointMark(painter, point);
  }
  std::ranges::reverse(ordered);
  paintPointNames(painter, ordered);
  painter.restore();
}

QImage edgeImage(const cv::Mat& image, const QSize& size) {
  const cv::Mat edges = edgeStrengthImage(image, {size.width(), size.height()});
  QImage result(edges.cols, edges.rows, QImage::Format_ARGB32_Premultiplied);
  for (int y = 0; y < edges.rows; ++y) {
    const auto* from = edges.ptr<uchar>(y);
    auto* to = reinterpret_cast<QRgb*>(result.scanLine(y));
    for (int x = 0; x < edges.cols; ++x) {
      constexpr int kNoise = 24; // of an image sensor
      const int strength = std::clamp(2 * (from[x] - kNoise), 0, 255);
      to[x] = qRgba(strength, strength, strength / 4, strength);
    }
  }
  return result;
}

} // namespace dewpoint::ui
