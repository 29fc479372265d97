// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QColor>

#include <utility>
#include <vector>

namespace dewpoint::ui {

/// The colors of particles by their weight: from dark to very bright, so that they can be told
/// apart without telling hues apart.
class ParticleRamp {
public:
  /// Dark violet over magenta to a bright yellow white: hardly anything in a room has these colors.
  static ParticleRamp heat();
  /// Shades of one color, to tell the particles of several targets apart.
  static ParticleRamp tinted(const QColor& color);

  /// The color of a weight, 0 to 1 of the largest one.
  QColor at(double weight) const;

private:
  explicit ParticleRamp(std::vector<QColor> stops) : stops_(std::move(stops)) {}

  std::vector<QColor> stops_; ///< equally far apart; at least two
};

} // namespace dewpoint::ui
