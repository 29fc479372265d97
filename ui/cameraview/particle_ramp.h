// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QColor>

#include <utility>
#include <vector>

namespace dewpoint::ui {

/// Color scale for particle weights, from dark to very bright, so that weights can be distinguished
/// by brightness alone.
class ParticleRamp {
public:
  /// Returns a scale from dark violet through magenta to bright yellow-white. These colors are rare
  /// in a room.
  static ParticleRamp heatRamp();
  /// Returns a scale of shades of `color`, so that the particles of several targets can be
  /// distinguished by the colors of the targets.
  static ParticleRamp tintedRamp(const QColor& color);

  /// Returns the color of a particle whose weight is `weight`, relative to the largest weight (0 to
  /// 1).
  QColor colorAt(double weight) const;

private:
  explicit ParticleRamp(std::vector<QColor> stops) : stops_(std::move(stops)) {}

  std::vector<QColor> stops_; ///< evenly spaced; at least two
};

} // namespace dewpoint::ui
