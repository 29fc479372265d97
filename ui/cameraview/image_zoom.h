// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/cameraview/image_placement.h"

#include <QPointF>
#include <QRect>
#include <QSize>

namespace dewpoint::ui {

/// What a zoom is about: an image (pixels) in a view (widget units) with so many device pixels per
/// widget unit. Neither size is empty.
struct ZoomRoom {
  QSize image;
  QSize view;
  double ratio = 1.0;
};

/// How far a view is zoomed into its image, and where: fitted at first, so that all of the image is
/// seen. A zoomed image leaves no more of the view empty than a fitted one; it keeps its scale and
/// its center when the view gets another size.
class ImageZoom {
public:
  /// Factor of one step of the wheel or of a key.
  static constexpr double kStep = 1.4142135623730951;
  /// Widget units per image pixel: not more, unless the image is larger already where it fits.
  static constexpr double kMost = 32.0;

  bool isFitted(const ZoomRoom& room) const;
  /// Makes the image `factor` times as large; the pixel at `position` (widget units) stays where it
  /// is. Not smaller than fitted.
  void zoomBy(double factor, const QPointF& position, const ZoomRoom& room);
  /// Moves a zoomed image along `way`, widget units, as far as it goes.
  void panBy(const QPointF& way, const ZoomRoom& room);
  /// Moves a zoomed image no more than needed to see a pixel of it.
  void reveal(const QPointF& pixel, const ZoomRoom& room);
  void fit() { scale_ = 0.0; }

  /// Where the image lies, its corner at a whole device pixel.
  ImagePlacement placement(const ZoomRoom& room) const;
  /// The part of the image that is to be drawn, pixels: what is seen and a little around it; all of
  /// it where it is fitted.
  QRect part(const ZoomRoom& room) const;
  /// The size of that part, device pixels.
  QSize partSize(const ZoomRoom& room) const;

private:
  ImagePlacement exactPlacement(const ZoomRoom& room) const;
  void moveTo(const QPointF& corner, double scale, const ZoomRoom& room);

  double scale_ = 0.0; ///< widget units per image pixel; 0: fitted
  QPointF center_; ///< in the middle of the view: pixels from the upper left corner of the image
};

} // namespace dewpoint::ui
