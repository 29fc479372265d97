// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/particle_painter.h"

#include "core/session/view/camera_overlay.h"

#include <QPainter>
#include <QPixmap>
#include <QPixmapCache>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dewpoint::ui {

namespace {

constexpr std::size_t kMostDots = 4000; ///< more are one cloud to the eye, and cost time
constexpr std::size_t kFewDots = 500;   ///< so many can be told apart by their size, too
constexpr int kDotLevels = 12;          ///< of weight
constexpr double kDotDiameter = 3.2;    ///< widget units, without halo
constexpr double kDotGrowth = 0.6;      ///< of the heaviest, where there are few
constexpr double kDotHalo = 1.0;
constexpr double kDotSide = kDotDiameter * (1.0 + kDotGrowth) + 2.0 * kDotHalo + 1.0;

/// Draws a dot for each level of weight, side by side.
QPixmap drawDots(const ParticleRamp& ramp, double growth, double ratio) {
  const int side = static_cast<int>(std::ceil(kDotSide * ratio));
  QPixmap dots(side * kDotLevels, side);
  dots.setDevicePixelRatio(ratio);
  dots.fill(Qt::transparent);
  QPainter painter(&dots);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  for (int level = 0; level < kDotLevels; ++level) {
    const double weight = static_cast<double>(level) / (kDotLevels - 1);
    const double radius = kDotDiameter * (1.0 + growth * weight) / 2.0;
    const QPointF center((level + 0.5) * side / ratio, 0.5 * side / ratio);
    painter.setBrush(QColor(0, 0, 0, 130));
    painter.drawEllipse(center, radius + kDotHalo, radius + kDotHalo);
    painter.setBrush(ramp.colorAt(weight));
    painter.drawEllipse(center, radius, radius);
  }
  return dots;
}

/// The same, kept from one target and frame to the next.
QPixmap dotsOf(const ParticleRamp& ramp, double growth, double ratio) {
  // A tinted ramp has no more colors than these, and none of them is the one of heat.
  const QString key =
      QStringLiteral("particle dots %1 %2 %3 %4 %5")
          .arg(ramp.colorAt(0.0).name(), ramp.colorAt(0.5).name(), ramp.colorAt(1.0).name())
          .arg(growth)
          .arg(ratio);
  QPixmap dots;
  if (!QPixmapCache::find(key, &dots)) {
    dots = drawDots(ramp, growth, ratio);
    QPixmapCache::insert(key, dots);
  }
  return dots;
}

/// By the root of the weight: most are far below the largest, and are to be told apart.
int levelOf(const CameraOverlay& overlay, std::size_t particle) {
  const double weight = particle < overlay.weights.size()
                            ? std::clamp(static_cast<double>(overlay.weights[particle]), 0.0, 1.0)
                            : 1.0;
  return static_cast<int>(std::lround(std::sqrt(weight) * (kDotLevels - 1)));
}

} // namespace

void paintParticles(QPainter& painter, const CameraOverlay& overlay,
                    const ImagePlacement& placement, const ParticleRamp& ramp) {
  if (overlay.particles.empty()) {
    return;
  }
  const double ratio = painter.device()->devicePixelRatioF();
  const bool few = overlay.particles.size() <= kFewDots;
  const QPixmap stamps = dotsOf(ramp, few ? kDotGrowth : 0.0, ratio);
  const double side = stamps.height();
  std::array<std::vector<QPainter::PixmapFragment>, kDotLevels> byLevel;
  const std::size_t stride = overlay.particles.size() / kMostDots + 1;
  for (std::size_t i = 0; i < overlay.particles.size(); i += stride) {
    const auto& at = overlay.particles[i];
    const int level = levelOf(overlay, i);
    byLevel[static_cast<std::size_t>(level)].push_back(QPainter::PixmapFragment::create(
        placement.positionOf({static_cast<double>(at.x()), static_cast<double>(at.y())}),
        QRectF(level * side, 0.0, side, side), 1.0 / ratio, 1.0 / ratio, 0.0,
        0.6 + 0.4 * level / (kDotLevels - 1)));
  }
  std::vector<QPainter::PixmapFragment> dots;
  dots.reserve(overlay.particles.size() / stride + 1);
  for (const auto& level : byLevel) {
    dots.insert(dots.end(), level.begin(), level.end());
  }
  painter.drawPixmapFragments(dots.data(), static_cast<int>(dots.size()), stamps);
}

} // namespace dewpoint::ui
