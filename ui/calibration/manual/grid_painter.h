// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/reference_grid.h"
#include "ui/cameraview/overlay_painter.h"

#include <QImage>
#include <QString>

#include <optional>

namespace cv {
class Mat;
}

namespace dewpoint::ui {

/// Where a pixel of an image lies in its widget; centers of pixels at integers.
QPointF placeOf(const Eigen::Vector2d& pixel, const ImagePlacement& placement);

/// Thin bright strokes on a dark halo, axes in colors of their own with names and meters.
void paintGrid(QPainter& painter, const ProjectedGrid& grid, const ImagePlacement& placement,
               double opacity);

/// A held point: a pin with a ring, so that it is not known by its color alone.
void paintPin(QPainter& painter, QPointF place);
/// The point that is dragged.
void paintGrip(QPainter& painter, QPointF place);

/// A measured point: a cross where it was clicked, a ring where the camera sees it, and the way
/// between them.
struct PaintedPoint {
  QString name;
  std::optional<QPointF> click;
  std::optional<QPointF> seen;
  bool chosen = false;
  bool worst = false;
};
void paintPoint(QPainter& painter, const PaintedPoint& point);

/// The edges of an image that is brought to this size, in one bright color on clear ground. Takes
/// long for large images; any thread.
QImage edgeImage(const cv::Mat& image, const QSize& size);

} // namespace dewpoint::ui
