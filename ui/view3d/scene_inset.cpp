// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/scene_inset.h"

#include "core/session/view/cloud_closeup.h"
#include "ui/style/mixed_color.h"
#include "ui/style/spacing.h"
#include "ui/style/theme.h"
#include "ui/style/to_color.h"
#include "ui/text/quantity_text.h"

#include <QPainter>
#include <QPainterPath>
#include <QPalette>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dewpoint::ui {
namespace {

constexpr double kSidePx = 112.0;
constexpr double kCornerPx = 6.0;
constexpr double kSmallCloudPx = 10.0; ///< across: what is smaller is enlarged
constexpr double kLeastWidth = 280.0;  ///< of the view, which shows the room first
constexpr double kLeastHeight = 220.0;
constexpr double kDotPx = 2.8; ///< across
constexpr double kTickPx = 3.0;
constexpr int kLevels = 6; ///< of weight, each drawn at once

void paintParticles(QPainter& painter, const CloudCloseup& closeup, const QColor& unlikely,
                    const QColor& likely) {
  std::array<QPolygonF, kLevels> levels;
  for (std::size_t k = 0; k < closeup.particles.size(); ++k) {
    // The root lifts the many faint ones into sight, as in the picture itself.
    const double share = std::sqrt(std::max(0.0F, closeup.weights[k]));
    const int level = std::clamp(int(share * kLevels), 0, kLevels - 1);
    levels[static_cast<std::size_t>(level)] +=
        QPointF(closeup.particles[k].x(), closeup.particles[k].y());
  }
  for (int level = 0; level < kLevels; ++level) {
    painter.setPen(QPen(mixedColor(unlikely, likely, double(level) / (kLevels - 1)), kDotPx,
                        Qt::SolidLine, Qt::RoundCap));
    painter.drawPoints(levels[static_cast<std::size_t>(level)]);
  }
}

void paintOutline(QPainter& painter, const ImageEllipse& outline, const QColor& color) {
  painter.save();
  painter.rotate(outline.angleRadians * 180.0 / std::numbers::pi);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(color, 1.2));
  painter.drawEllipse(QPointF(), outline.semiMajorAxis, outline.semiMinorAxis);
  painter.restore();
}

/// In the lower right corner of the box, with its length above it.
void paintBar(QPainter& painter, const QRectF& box, const CloudCloseup& closeup,
              const QColor& ground, const QColor& ink) {
  const double length = closeup.scaleBarMeters / closeup.metersPerPixel;
  const QPointF right = box.bottomRight() - QPointF(kSpacing, kSpacing);
  const QPointF left = right - QPointF(length, 0.0);
  QPainterPath bar;
  bar.moveTo(left - QPointF(0.0, kTickPx));
  bar.lineTo(left);
  bar.lineTo(right);
  bar.lineTo(right - QPointF(0.0, kTickPx));
  QPainterPath text;
  const QString said = lengthText(closeup.scaleBarMeters, LengthForm::Short);
  const QFontMetricsF metrics(painter.font());
  text.addText(right.x() - metrics.horizontalAdvance(said), right.y() - kTickPx - 2.0,
               painter.font(), said);
  painter.strokePath(text, QPen(ground, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.strokePath(bar, QPen(ground, 3.0));
  painter.strokePath(bar, QPen(ink, 1.2));
  painter.fillPath(text, ink);
}

} // namespace

bool SceneInset::isTooSmall(const TargetSnapshot& target) const {
  const auto reach = cloudSemiAxis(target);
  if (!reach || particleCountOf(target.estimate) <= 0 || !target.target.isShown) {
    return false;
  }
  const Eigen::Vector3d mean = positionOf(target.estimate)->mean;
  return scene_.isInFront(mean) && 2.0 * scene_.lengthInLogicalPixels(mean, *reach) < kSmallCloudPx;
}

int SceneInset::targetToEnlarge(const QWidget& view, int chosen) const {
  if (!snapshot_ || !fitsInView(view)) {
    return -1;
  }
  const auto& targets = snapshot_->targets;
  if (chosen >= 0 && chosen < int(targets.size())) {
    return isTooSmall(targets[static_cast<std::size_t>(chosen)]) ? chosen : -1;
  }
  const auto found =
      std::ranges::find_if(targets, [this](const auto& target) { return isTooSmall(target); });
  return found == targets.end() ? -1 : int(found - targets.begin());
}

bool SceneInset::fitsInView(const QWidget& view) {
  return view.width() >= kLeastWidth && view.height() >= kLeastHeight;
}

QRectF SceneInset::usualArea(const QWidget& view) {
  return {view.width() - kSpacing - kSidePx, view.height() - kSpacing - kSidePx, kSidePx, kSidePx};
}

int SceneInset::coveredCount(const QWidget& view, const QRectF& box) const {
  const ViewProjection projection(view, scene_);
  const auto glyphs = scene_.cameraGlyphs();
  const auto texts = scene_.textAreas();
  const auto isCovered = [&](const CameraGlyph& glyph) {
    return scene_.isInFront(glyph.center) && box.contains(projection.toWidget(glyph.center));
  };
  const auto isTextCovered = [&](const Eigen::AlignedBox2d& text) {
    return QRectF(projection.toWidget(text.min()), projection.toWidget(text.max()))
        .normalized()
        .intersects(box);
  };
  return static_cast<int>(std::ranges::count_if(glyphs, isCovered) +
                          std::ranges::count_if(texts, isTextCovered));
}

QRectF SceneInset::shownArea(const QWidget& view, int chosen) const {
  if (targetToEnlarge(view, chosen) < 0) {
    return {};
  }
  const QRectF below = usualArea(view);
  const QRectF above = below.translated(0.0, kSpacing - below.top());
  const int covered = coveredCount(view, below);
  return covered > 0 && coveredCount(view, above) < covered ? above : below;
}

void SceneInset::paint(QPainter& painter, const QWidget& view, int chosen) const {
  const int index = targetToEnlarge(view, chosen);
  if (index < 0) {
    return;
  }
  const TargetSnapshot& shown = snapshot_->targets[static_cast<std::size_t>(index)];
  const auto closeup =
      cloudCloseup(shown, scene_.rightAxisInWorld(), scene_.upAxisInWorld(), kSidePx / 2.0);
  if (!closeup) {
    return;
  }
  const QPalette& palette = view.palette();
  const bool dark = isDarkPalette(palette);
  const QColor ground = palette.color(QPalette::Base);
  const QColor ink = palette.color(QPalette::Text);
  const QColor color = toQColor(scene_.colorOf(static_cast<std::size_t>(index)));
  const QRectF box = shownArea(view, chosen);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  // A line to what is enlarged, up to the box.
  const QPointF mean = ViewProjection(view, scene_).toWidget(positionOf(shown.estimate)->mean);
  QColor faint = ink;
  faint.setAlphaF(0.35F);
  if (!box.contains(mean)) {
    QPainterPath beside;
    beside.addRect(QRectF(view.rect()));
    QPainterPath inside;
    inside.addRect(box);
    painter.setClipPath(beside - inside);
    QColor fainter = ink;
    fainter.setAlphaF(0.18F);
    painter.setPen(QPen(fainter, 1.0));
    painter.drawLine(mean, box.center());
    painter.setClipping(false);
  }
  QPainterPath frame;
  frame.addRoundedRect(box, kCornerPx, kCornerPx);
  QColor veil = ground;
  veil.setAlphaF(0.92F);
  painter.fillPath(frame, veil);
  painter.setClipPath(frame);
  painter.translate(box.center());
  paintParticles(painter, *closeup, mixedColor(ground, color, 0.45),
                 mixedColor(color, dark ? QColor(Qt::white) : QColor(Qt::black), dark ? 0.6 : 0.4));
  paintOutline(painter, closeup->outline, mixedColor(color, ink, 0.35));
  painter.translate(-box.center());
  paintBar(painter, box, *closeup, ground, ink);
  painter.setClipping(false);
  painter.strokePath(frame, QPen(faint, 1.0));
  painter.restore();
}

} // namespace dewpoint::ui
