// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/cameraview/image_placement.h"

#include <QPointF>
#include <QRect>
#include <QSize>

namespace dewpoint::ui {

/// Geometry for zooming: image size (pixels), view size (widget units), and device pixels per
/// widget unit. Neither size is empty.
struct ZoomSizes {
  QSize imageSize;
  QSize viewSize;
  double pixelRatio = 1.0;
};

/// Zoom and position of an image in a view. Initially, the image is fitted, so that all of it is
/// visible. A zoomed image keeps its scale and center when the view size changes, and never leaves
/// more of the view empty than a fitted image.
class ImageZoom {
public:
  /// Zoom factor per wheel step or key press.
  static constexpr double kZoomStep = 1.4142135623730951;
  /// Maximum scale of a zoomed image, in widget units per image pixel. The scale of a fitted image
  /// may be larger.
  static constexpr double kMaxScale = 32.0;

  bool isFitted(const ZoomSizes& sizes) const;
  /// Multiplies the scale of the image by `factor`. The image never becomes smaller than the fitted
  /// image. The pixel at `position` (widget units) stays in place.
  void zoomBy(double factor, const QPointF& position, const ZoomSizes& sizes);
  /// Moves a zoomed image by `offset` (widget units), but not so far that it leaves more of the
  /// view empty than a fitted image.
  void panBy(const QPointF& offset, const ZoomSizes& sizes);
  /// Moves a zoomed image just far enough to make `pixel` visible.
  void reveal(const QPointF& pixel, const ZoomSizes& sizes);
  void fitToView() { scale_ = 0.0; }

  /// Returns the placement of the image. Its corner lies on a whole device pixel.
  ImagePlacement placement(const ZoomSizes& sizes) const;
  /// Returns the part of the image to draw, in pixels: the visible part plus a small margin, or the
  /// whole image if it is fitted.
  QRect visiblePart(const ZoomSizes& sizes) const;
  /// Returns the size of visiblePart() on the screen, in device pixels.
  QSize visiblePartSize(const ZoomSizes& sizes) const;

private:
  ImagePlacement exactPlacement(const ZoomSizes& sizes) const;
  void moveTo(const QPointF& corner, double scale, const ZoomSizes& sizes);

  double scale_ = 0.0; ///< widget units per image pixel; 0 means fitted
  /// Image point at the view center, in pixels from the upper left corner of the image.
  QPointF center_;
};

} // namespace dewpoint::ui
