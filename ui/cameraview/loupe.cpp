// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/loupe.h"

#include "core/calibration/manual/click_aids.h"
#include "ui/style/image.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr double kLoupeSide = 128.0;
constexpr double kLeastLoupeSide = 40.0; ///< a smaller one shows nothing
constexpr double kBesidePointer = 22.0;
constexpr int kLoupeFactor = 8;
constexpr double kLoupeArm = 10.0; ///< of the cross
constexpr double kLoupeGap = 3.0;  ///< in its middle, where one looks

} // namespace

QRectF loupeRect(const QPointF& pointer, const QSizeF& room) {
  const double side = std::min({kLoupeSide, room.width() / 2.0 - kBesidePointer, room.height()});
  if (side < kLeastLoupeSide) {
    return {};
  }
  // Beside it there is always room; below it is better than above, where a hand may point from.
  const double right = pointer.x() + kBesidePointer;
  const bool fits = right + side <= room.width();
  const double x = fits ? right : pointer.x() - kBesidePointer - side;
  const double y = pointer.y() + kBesidePointer + side <= room.height()
                       ? pointer.y() + kBesidePointer
                       : pointer.y() - kBesidePointer - side;
  return {std::clamp(x, 0.0, room.width() - side), std::clamp(y, 0.0, room.height() - side), side,
          side};
}

void paintLoupe(QPainter& painter, const QRectF& place, const cv::Mat& image, const QPointF& pixel,
                const QPointF& meant) {
  const double ratio = painter.device()->devicePixelRatioF();
  const int factor = std::max(1, static_cast<int>(std::lround(kLoupeFactor * ratio)));
  QImage picture = toQImage(magnified(
      image, {pixel.x(), pixel.y()}, static_cast<int>(std::lround(place.width() * ratio)), factor));
  picture.setDevicePixelRatio(ratio);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath circle;
  circle.addEllipse(place);
  painter.setClipPath(circle, Qt::IntersectClip);
  painter.drawImage(place, picture);
  const QPointF cross = place.center() + (meant - pixel) * (factor / ratio);
  for (const auto& [ink, width] :
       {std::pair(QColor(0, 0, 0, 170), 3.0), std::pair(QColor("#f0e442"), 1.2)}) {
    painter.setPen(QPen(ink, width));
    for (const QPointF& arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
      painter.drawLine(cross + arm * kLoupeGap, cross + arm * kLoupeArm);
    }
  }
  painter.restore();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  const QRectF rim = place.adjusted(1.0, 1.0, -1.0, -1.0);
  painter.setPen(QPen(QColor(0, 0, 0, 150), 3.5));
  painter.drawEllipse(rim);
  painter.setPen(QPen(Qt::white, 1.5));
  painter.drawEllipse(rim);
  painter.restore();
}

} // namespace dewpoint::ui
