// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/image_zoom.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr double kRevealMargin = 24.0; ///< widget units between a revealed pixel and the border
constexpr int kSpareShare = 16; ///< this part of what is seen is drawn beyond it, so that a drag
                                ///< finds it there

QSize fittedDeviceSize(const ZoomSizes& sizes) {
  const QSizeF shown = QSizeF(sizes.imageSize).scaled(QSizeF(sizes.viewSize), Qt::KeepAspectRatio);
  return {std::max(1, static_cast<int>(std::lround(shown.width() * sizes.pixelRatio))),
          std::max(1, static_cast<int>(std::lround(shown.height() * sizes.pixelRatio)))};
}

double wholeDevicePixel(double position, double ratio) {
  return std::round(position * ratio) / ratio;
}

ImagePlacement fittedPlacement(const ZoomSizes& sizes) {
  const QSizeF shown = QSizeF(fittedDeviceSize(sizes)) / sizes.pixelRatio;
  // Not only where it is drawn: a zoom would enlarge the difference.
  return {
      QPointF(wholeDevicePixel((sizes.viewSize.width() - shown.width()) / 2.0, sizes.pixelRatio),
              wholeDevicePixel((sizes.viewSize.height() - shown.height()) / 2.0, sizes.pixelRatio)),
      shown.width() / sizes.imageSize.width()};
}

/// Where an image may begin along one axis: the band beside a fitted image is never wider. So the
/// pixel under a pointer can stay there from the fit on.
double coveringCorner(double corner, double shown, double view, double band) {
  return std::clamp(corner, view - shown - band, band);
}

QPointF coveringCorner(const QPointF& corner, double scale, const ZoomSizes& sizes) {
  const QPointF band = fittedPlacement(sizes).topLeft;
  return {
      coveringCorner(corner.x(), sizes.imageSize.width() * scale, sizes.viewSize.width(), band.x()),
      coveringCorner(corner.y(), sizes.imageSize.height() * scale, sizes.viewSize.height(),
                     band.y())};
}

/// The pixels from `first` to `last` and a little more, on a grid of so many pixels, within
/// `count`.
std::pair<int, int> sparePixels(double first, double last, int count) {
  const int step = std::max(1, static_cast<int>((last - first) / kSpareShare));
  const int from = static_cast<int>(std::floor(first / step)) * step;
  const int to = static_cast<int>(std::ceil(last / step)) * step;
  const int begin = std::clamp(from, 0, count - 1);
  return {begin, std::clamp(to, begin + 1, count)};
}

} // namespace

bool ImageZoom::isFitted(const ZoomSizes& sizes) const {
  return scale_ <= fittedPlacement(sizes).scale;
}

ImagePlacement ImageZoom::exactPlacement(const ZoomSizes& sizes) const {
  if (isFitted(sizes)) {
    return fittedPlacement(sizes);
  }
  const QPointF corner =
      QPointF(sizes.viewSize.width(), sizes.viewSize.height()) / 2.0 - center_ * scale_;
  return {coveringCorner(corner, scale_, sizes), scale_};
}

void ImageZoom::moveTo(const QPointF& corner, double scale, const ZoomSizes& sizes) {
  const QPointF covering = coveringCorner(corner, scale, sizes);
  scale_ = scale;
  center_ = (QPointF(sizes.viewSize.width(), sizes.viewSize.height()) / 2.0 - covering) / scale;
}

void ImageZoom::zoomBy(double factor, const QPointF& position, const ZoomSizes& sizes) {
  const ImagePlacement now = exactPlacement(sizes);
  const double least = fittedPlacement(sizes).scale;
  const double scale = std::clamp(now.scale * factor, least, std::max(least, kMaxScale));
  constexpr double kAlmost = 1.0 + 1e-6; // as many steps back as there were in lead to the fit
  if (scale <= least * kAlmost) {
    fitToView();
    return;
  }
  moveTo(position - (position - now.topLeft) * (scale / now.scale), scale, sizes);
}

void ImageZoom::panBy(const QPointF& offset, const ZoomSizes& sizes) {
  if (!isFitted(sizes)) {
    moveTo(exactPlacement(sizes).topLeft + offset, scale_, sizes);
  }
}

void ImageZoom::reveal(const QPointF& pixel, const ZoomSizes& sizes) {
  const QPointF at = exactPlacement(sizes).positionOf(pixel);
  const auto missing = [](double position, double length) {
    const double margin = std::min(kRevealMargin, length / 4.0);
    return std::clamp(position, margin, length - margin) - position;
  };
  panBy({missing(at.x(), sizes.viewSize.width()), missing(at.y(), sizes.viewSize.height())}, sizes);
}

ImagePlacement ImageZoom::placement(const ZoomSizes& sizes) const {
  const ImagePlacement exact = exactPlacement(sizes);
  return {QPointF(wholeDevicePixel(exact.topLeft.x(), sizes.pixelRatio),
                  wholeDevicePixel(exact.topLeft.y(), sizes.pixelRatio)),
          exact.scale};
}

QRect ImageZoom::visiblePart(const ZoomSizes& sizes) const {
  if (isFitted(sizes)) {
    return {{0, 0}, sizes.imageSize};
  }
  const ImagePlacement now = placement(sizes);
  const QPointF first = -now.topLeft / now.scale;
  const QPointF last = first + QPointF(sizes.viewSize.width(), sizes.viewSize.height()) / now.scale;
  const auto [left, right] = sparePixels(first.x(), last.x(), sizes.imageSize.width());
  const auto [top, bottom] = sparePixels(first.y(), last.y(), sizes.imageSize.height());
  return {left, top, right - left, bottom - top};
}

QSize ImageZoom::visiblePartSize(const ZoomSizes& sizes) const {
  if (isFitted(sizes)) {
    return fittedDeviceSize(sizes);
  }
  const QSizeF size = QSizeF(visiblePart(sizes).size()) * (scale_ * sizes.pixelRatio);
  return {std::max(1, static_cast<int>(std::lround(size.width()))),
          std::max(1, static_cast<int>(std::lround(size.height())))};
}

} // namespace dewpoint::ui
