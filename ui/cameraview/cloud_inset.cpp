// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/cloud_inset.h"

#include "core/calibration/manual/click_aids.h"
#include "core/session/view/camera_overlay.h"
#include "ui/cameraview/inset_geometry.h"
#include "ui/cameraview/overlay_painter.h"
#include "ui/cameraview/particle_painter.h"
#include "ui/style/halo.h"
#include "ui/style/image.h"
#include "ui/text/quantity_text.h"

#include <QLineF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {

constexpr double kInsetRounding = 4.0;
constexpr double kInsetPenWidth = 1.2;
constexpr double kLeastBracket = 11.0; ///< around the place in the image, widget units
constexpr double kBarShare = 0.42;     ///< of the inset, at most, is the scale bar long
constexpr Halo kInsetHalo{110, 1.8};
const QColor kInsetInk(255, 255, 255, 215);
const QColor kLeadInk(255, 255, 255, 150); // it crosses what is to be seen

/// Its text has as many decimals as it needs.
QString barText(double length) {
  return pixelText(length, std::max(0, -static_cast<int>(std::floor(std::log10(length) + 1e-9))));
}

/// A square around the place, and a line from it to the inset.
void paintLead(QPainter& painter, const QRectF& place, const QRectF& inset) {
  drawWithHalo(
      painter, kInsetInk, 1.0, [&] { painter.drawRect(place); }, Qt::SolidLine, kInsetHalo);
  const QPointF near(std::clamp(place.center().x(), inset.left(), inset.right()),
                     std::clamp(place.center().y(), inset.top(), inset.bottom()));
  QLineF line(near, place.center());
  const QPointF way = place.center() - near;
  const double longer = std::max(std::abs(way.x()), std::abs(way.y()));
  if (longer <= place.width() / 2.0) {
    return; // it touches the inset
  }
  line.setP2(place.center() - way * (place.width() / 2.0 / longer)); // up to the square
  drawWithHalo(
      painter, kLeadInk, 1.0, [&] { painter.drawLine(line); }, Qt::SolidLine, kInsetHalo);
}

void paintScaleBar(QPainter& painter, const QRectF& inset, double scale) {
  const double length = scaleBarLength(scale, kBarShare * inset.width());
  const QString text = barText(length);
  painter.save();
  QFont small = painter.font();
  small.setPointSizeF(small.pointSizeF() * 0.85);
  painter.setFont(small);
  const QFontMetricsF metrics(small);
  const QPointF left = inset.bottomLeft() + QPointF(7.0, -7.0);
  const QPointF right = left + QPointF(length * scale, 0.0);
  const Halo halo{170, 2.0, true, Qt::FlatCap, Qt::MiterJoin};
  drawWithHalo(
      painter, Qt::white, 2.0, [&] { painter.drawLine(left, right); }, Qt::SolidLine, halo);
  const QPointF words = left + QPointF(0.0, -metrics.descent() - 2.0);
  painter.setPen(QColor(0, 0, 0, 120));
  for (const QPointF& beside : {QPointF(-1, 0), QPointF(1, 0), QPointF(0, -1), QPointF(0, 1)}) {
    painter.drawText(words + beside, text); // its halo
  }
  painter.setPen(Qt::white);
  painter.drawText(words, text);
  painter.restore();
}

} // namespace

void paintCloudInset(QPainter& painter, const CloudInset& subject) {
  constexpr double kLeastRadius = 1e-3; // of particles that are all at one place
  const auto& ellipse = subject.overlay.ellipse;
  const double diameter = 2.0 * std::max(kLeastRadius, cloudRadius(subject.overlay));
  const double ratio = painter.device()->devicePixelRatioF();
  const auto side = insetSideLength(subject.area);
  if (!ellipse || !side || subject.overlay.particles.empty() ||
      !isTightCloud(diameter * subject.placement.scale)) {
    return;
  }
  const auto factor = insetMagnification(diameter, *side * ratio);
  const QPointF center(ellipse->center.x(), ellipse->center.y());
  const QPointF target = subject.placement.positionOf(center);
  if (!factor || !subject.area.contains(target)) {
    return;
  }
  const QRectF square = insetRect(subject.area, *side, target, subject.occupiedAreas);
  const double scale = *factor / ratio;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const double shown = std::max(kLeastBracket, *side / scale * subject.placement.scale);
  QRectF place(0.0, 0.0, shown, shown);
  place.moveCenter(target);
  paintLead(painter, place, square);

  QPainterPath frame;
  frame.addRoundedRect(square, kInsetRounding, kInsetRounding);
  painter.save();
  painter.setClipPath(frame, Qt::IntersectClip);
  QImage picture = toQImage(magnified(subject.image, ellipse->center,
                                      static_cast<int>(std::lround(*side * ratio)), *factor));
  picture.setDevicePixelRatio(ratio);
  painter.drawImage(square, picture);
  const ImagePlacement enlarged{square.center() - (center + QPointF(0.5, 0.5)) * scale, scale};
  paintParticles(painter, subject.overlay, enlarged, subject.ramp);
  drawWithHalo(painter, subject.color, 1.3, [&] { paintEllipse(painter, *ellipse, enlarged); });
  paintScaleBar(painter, square, scale);
  painter.restore();
  drawWithHalo(
      painter, kInsetInk, kInsetPenWidth, [&] { painter.drawPath(frame); }, Qt::SolidLine,
      kInsetHalo);
  painter.restore();
}

} // namespace dewpoint::ui
