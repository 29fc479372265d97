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

QSize fittedDeviceSize(const ZoomRoom& room) {
  const QSizeF shown = QSizeF(room.image).scaled(QSizeF(room.view), Qt::KeepAspectRatio);
  return {std::max(1, static_cast<int>(std::lround(shown.width() * room.ratio))),
          std::max(1, static_cast<int>(std::lround(shown.height() * room.ratio)))};
}

double wholeDevicePixel(double position, double ratio) {
  return std::round(position * ratio) / ratio;
}

ImagePlacement fittedPlacement(const ZoomRoom& room) {
  const QSizeF shown = QSizeF(fittedDeviceSize(room)) / room.ratio;
  // Not only where it is drawn: a zoom would enlarge the difference.
  return {QPointF(wholeDevicePixel((room.view.width() - shown.width()) / 2.0, room.ratio),
                  wholeDevicePixel((room.view.height() - shown.height()) / 2.0, room.ratio)),
          shown.width() / room.image.width()};
}

/// Where an image may begin along one axis: the band beside a fitted image is never wider. So the
/// pixel under a pointer can stay there from the fit on.
double coveringCorner(double corner, double shown, double view, double band) {
  return std::clamp(corner, view - shown - band, band);
}

QPointF coveringCorner(const QPointF& corner, double scale, const ZoomRoom& room) {
  const QPointF band = fittedPlacement(room).corner;
  return {coveringCorner(corner.x(), room.image.width() * scale, room.view.width(), band.x()),
          coveringCorner(corner.y(), room.image.height() * scale, room.view.height(), band.y())};
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

bool ImageZoom::isFitted(const ZoomRoom& room) const {
  return scale_ <= fittedPlacement(room).scale;
}

ImagePlacement ImageZoom::exactPlacement(const ZoomRoom& room) const {
  if (isFitted(room)) {
    return fittedPlacement(room);
  }
  const QPointF corner = QPointF(room.view.width(), room.view.height()) / 2.0 - center_ * scale_;
  return {coveringCorner(corner, scale_, room), scale_};
}

void ImageZoom::moveTo(const QPointF& corner, double scale, const ZoomRoom& room) {
  const QPointF covering = coveringCorner(corner, scale, room);
  scale_ = scale;
  center_ = (QPointF(room.view.width(), room.view.height()) / 2.0 - covering) / scale;
}

void ImageZoom::zoomBy(double factor, const QPointF& position, const ZoomRoom& room) {
  const ImagePlacement now = exactPlacement(room);
  const double least = fittedPlacement(room).scale;
  const double scale = std::clamp(now.scale * factor, least, std::max(least, kMost));
  constexpr double kAlmost = 1.0 + 1e-6; // as many steps back as there were in lead to the fit
  if (scale <= least * kAlmost) {
    fit();
    return;
  }
  moveTo(position - (position - now.corner) * (scale / now.scale), scale, room);
}

void ImageZoom::panBy(const QPointF& way, const ZoomRoom& room) {
  if (!isFitted(room)) {
    moveTo(exactPlacement(room).corner + way, scale_, room);
  }
}

void ImageZoom::reveal(const QPointF& pixel, const ZoomRoom& room) {
  const QPointF at = exactPlacement(room).positionOf(pixel);
  const auto missing = [](double position, double length) {
    const double margin = std::min(kRevealMargin, length / 4.0);
    return std::clamp(position, margin, length - margin) - position;
  };
  panBy({missing(at.x(), room.view.width()), missing(at.y(), room.view.height())}, room);
}

ImagePlacement ImageZoom::placement(const ZoomRoom& room) const {
  const ImagePlacement exact = exactPlacement(room);
  return {QPointF(wholeDevicePixel(exact.corner.x(), room.ratio),
                  wholeDevicePixel(exact.corner.y(), room.ratio)),
          exact.scale};
}

QRect ImageZoom::part(const ZoomRoom& room) const {
  if (isFitted(room)) {
    return {{0, 0}, room.image};
  }
  const ImagePlacement now = placement(room);
  const QPointF first = -now.corner / now.scale;
  const QPointF last = first + QPointF(room.view.width(), room.view.height()) / now.scale;
  const auto [left, right] = sparePixels(first.x(), last.x(), room.image.width());
  const auto [top, bottom] = sparePixels(first.y(), last.y(), room.image.height());
  return {left, top, right - left, bottom - top};
}

QSize ImageZoom::partSize(const ZoomRoom& room) const {
  if (isFitted(room)) {
    return fittedDeviceSize(room);
  }
  const QSizeF size = QSizeF(part(room).size()) * (scale_ * room.ratio);
  return {std::max(1, static_cast<int>(std::lround(size.width()))),
          std::max(1, static_cast<int>(std::lround(size.height())))};
}

} // namespace dewpoint::ui
