// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/legend_picture.h"

#include "core/session/snapshot/display_colors.h"
#include "core/session/view/camera_overlay.h"
#include "ui/cameraview/overlay_painter.h"
#include "ui/cameraview/particle_ramp.h"
#include "ui/style/halo.h"
#include "ui/style/to_color.h"

#include <QLinearGradient>
#include <QPainter>
#include <QPainterPath>

#include <cmath>
#include <numbers>

namespace dewpoint::ui {

namespace {

constexpr float kMaskTint = 0.25F; ///< as in the images
constexpr QSize kPictureSize(104, 64);
constexpr double kCorner = 5.0;
constexpr double kBallRadius = 15.0;
constexpr int kDots = 60;
const QColor kBall(222, 84, 150); ///< the demo's pink
const QColor kWall(206, 201, 190);
const QColor kTable(158, 118, 78);

/// Points of a cloud that is the same each time: golden angles, dense in the middle.
std::vector<Eigen::Vector2f> cloudAround(const QPointF& center, double radius) {
  std::vector<Eigen::Vector2f> cloud;
  for (int k = 0; k < kDots; ++k) {
    const double angle = k * std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double far = radius * (k + 0.5) / kDots;
    cloud.emplace_back(static_cast<float>(center.x() + 1.5 * far * std::cos(angle)),
                       static_cast<float>(center.y() + far * std::sin(angle)));
  }
  return cloud;
}

void paintScene(QPainter& painter, const QRectF& place, const QPointF& ball) {
  painter.fillRect(place, kWall);
  painter.fillRect(place.adjusted(0, 0.72 * place.height(), 0, 0), kTable);
  painter.setPen(Qt::NoPen);
  painter.setBrush(kBall);
  painter.drawEllipse(ball, kBallRadius, kBallRadius);
}

CameraOverlay overlayOf(LegendSign sign, const QPointF& ball) {
  const Eigen::Vector2d center(ball.x(), ball.y());
  CameraOverlay overlay;
  switch (sign) {
  case LegendSign::Particles:
    overlay.particles = cloudAround(ball, 22.0);
    for (int k = 0; k < kDots; ++k) {
      overlay.weights.push_back(1.0F - static_cast<float>(k) / kDots);
    }
    break;
  case LegendSign::Estimate:
    overlay.estimate = center;
    break;
  case LegendSign::Belief:
    overlay.ellipse = ImageEllipse{center, 27.0, 11.0, 0.35};
    break;
  case LegendSign::Outline:
    overlay.outline = ImageEllipse{center, 19.0, 17.0, 0.0};
    break;
  case LegendSign::Truth:
    overlay.truth = center;
    break;
  case LegendSign::Best:
    overlay.bestParticle = center;
    break;
  case LegendSign::Ray:
  case LegendSign::Mask:
  case LegendSign::Inset:
  case LegendSign::Range:
    break;
  }
  return overlay;
}

/// A box in the corner with an enlarged cloud, and a line from it to the ball.
void paintInsetSign(QPainter& painter, const QPointF& ball, const QSizeF& size) {
  constexpr double kSide = 30.0;
  constexpr double kBracket = 9.0;
  const QRectF box(3.0, size.height() - kSide - 3.0, kSide, kSide);
  const QRectF place(ball - QPointF(kBracket / 2.0, kBracket / 2.0), QSizeF(kBracket, kBracket));
  drawWithHalo(painter, Qt::white, 1.0, [&] {
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(place);
    painter.drawLine(box.topRight() + QPointF(0.0, 4.0), place.bottomLeft());
  });
  painter.setPen(Qt::NoPen);
  painter.setBrush(kBall.darker(130));
  painter.drawRoundedRect(box, 4.0, 4.0);
  painter.setBrush(Qt::white);
  for (const Eigen::Vector2f& dot : cloudAround(box.center(), 0.26 * kSide)) {
    painter.drawEllipse(QPointF(dot.x(), dot.y()), 0.9, 0.9);
  }
  drawWithHalo(painter, Qt::white, 1.0, [&] {
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(box, 4.0, 4.0);
  });
}

/// A path to the ball, with a dark band along a part of it.
void paintRangeSign(QPainter& painter, const QPointF& ball, const QSizeF& size) {
  QPainterPath path(QPointF(4.0, size.height() - 8.0));
  path.quadTo(QPointF(ball.x() - 30.0, 2.0), ball);
  QPainterPath part(path.pointAtPercent(0.2));
  for (double at = 0.25; at < 0.6; at += 0.05) {
    part.lineTo(path.pointAtPercent(at));
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kBall.darker(120), 2.0));
  painter.drawPath(path);
  painter.setPen(QPen(QColor(0, 0, 0, 150), 7.0, Qt::SolidLine, Qt::FlatCap));
  painter.drawPath(part);
}

} // namespace

LegendPicture::LegendPicture(LegendSign sign, QWidget* parent) : QWidget(parent), sign_(sign) {
  setFixedSize(kPictureSize);
  setAccessibleName(meaningOf(sign));
}

QString LegendPicture::meaningOf(LegendSign sign) {
  switch (sign) {
  case LegendSign::Particles:
    return tr("Dots: particles. Each one is a guess of where the target is. Brighter particles fit "
              "the images better.");
  case LegendSign::Estimate:
    return tr("Cross: the estimate, the weighted mean of the particles.");
  case LegendSign::Belief:
    return tr("Solid ellipse: the target is inside with a probability of 95 %. A smaller ellipse "
              "is more certain.");
  case LegendSign::Outline:
    return tr("Dashed ellipse: the size of the target itself, if the target is not a ball.");
  case LegendSign::Truth:
    return tr("White diamond: the true position of the target, known only in simulated scenes such "
              "as the demo.");
  case LegendSign::Best:
    return tr("Triangle: the particle of highest weight (View › Show best particle).");
  case LegendSign::Ray:
    return tr("Line across the image: the line of sight of another camera, shown while you drag "
              "the target. The target must lie on this line.");
  case LegendSign::Mask:
    return tr("Tinted and outlined: regions with the color of the target (View › Show mask).");
  case LegendSign::Inset:
    return tr("Box in a corner: the particles, enlarged, if they are too close together to be seen "
              "in the view. A line shows where they are, and the bar shows the scale.");
  case LegendSign::Range:
    return tr("Dark band along a path in the bird's-eye view: the time range that is selected in "
              "the timeline. Press Esc in the timeline to remove the selection.");
  }
  return {};
}

void LegendPicture::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath edge;
  edge.addRoundedRect(QRectF(rect()), kCorner, kCorner);
  painter.setClipPath(edge);
  const QPointF ball(width() / 2.0, height() / 2.0);
  paintScene(painter, QRectF(rect()), ball);
  const QColor color = toQColor(legibleColor(
      DisplayColor(kBall.redF(), kBall.greenF(), kBall.blueF()), DisplayBackground::Image));
  if (sign_ == LegendSign::Mask) {
    QColor tint = color;
    tint.setAlphaF(kMaskTint);
    painter.setPen(Qt::NoPen);
    painter.setBrush(tint);
    painter.drawEllipse(ball, kBallRadius, kBallRadius);
    drawWithHalo(painter, color, 1.4, [&] {
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(ball, kBallRadius, kBallRadius);
    });
  } else if (sign_ == LegendSign::Ray) {
    drawWithHalo(painter, color, 1.6,
                 [&] { painter.drawLine(QPointF(0, 10), QPointF(width(), 48)); });
  } else if (sign_ == LegendSign::Inset) {
    paintInsetSign(painter, ball, size());
  } else if (sign_ == LegendSign::Range) {
    paintRangeSign(painter, ball, size());
  }
  // Pixels of the image are those of the picture; their centers lie at integers.
  paintOverlay(painter, overlayOf(sign_, ball), {QPointF(-0.5, -0.5), 1.0}, color,
               ParticleRamp::heatRamp());
}

} // namespace dewpoint::ui
