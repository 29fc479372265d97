// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/reference_grid.h"
#include "ui/cameraview/overlay_painter.h"

#include <QImage>
#include <QString>

#include <optional>
#include <vector>

namespace cv {
class Mat;
}

namespace dewpoint::ui {

/// Returns the widget position of an image pixel. Pixel centers lie at integer coordinates.
QPointF widgetPosition(const Eigen::Vector2d& pixel, const ImagePlacement& placement);

/// Draws the reference grid as thin bright lines with a dark halo. Each axis has its own color, a
/// name and labels in meters. Where there is room, the names and labels lie outside the grid.
void paintGrid(QPainter& painter, const ProjectedGrid& grid, const ImagePlacement& placement,
               double opacity);

/// Draws a fixed point as a pin with a ring, which can be recognized without its color.
void paintPin(QPainter& painter, QPointF place);
/// Draws the point that the user is dragging.
void paintGrip(QPainter& painter, QPointF place);

/// Measured point to draw: a cross where the user clicked the point, a ring at its projection, and
/// a line between them. Positions are in widget coordinates.
struct PaintedPoint {
  QString name;
  std::optional<QPointF> click;
  std::optional<QPointF> projection;
  bool isSelected = false;
  bool isMisfit = false;        ///< does not fit the other points
  bool isInOtherFrames = false; ///< was clicked only in other frames
};
/// Draws measured points. The selected point and a point that does not fit the others are
/// highlighted. Points that were clicked only in other frames are faint; their names are left out
/// where they would cover something.
void paintPoints(QPainter& painter, const std::vector<PaintedPoint>& points);

/// Returns the edges found in `image`, in one bright color on a transparent background of size
/// `size`. Slow for large images. May be called from any thread.
QImage edgeImage(const cv::Mat& image, const QSize& size);

} // namespace dewpoint::ui
