// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/likelihood/color_cells.h"

#include <cstddef>
#include <vector>

namespace dewpoint::color {

/// Smoothed density of weighted colors in the space of all colors.
///
/// A fraction of each color's weight is spread as changes in lighting would spread the color. The
/// weight is spread along the ray through black (brightness), toward gray and away from gray
/// (highlights, haze, saturation), and around the gray axis (tint of the light). The spread is a
/// normal distribution with the standard deviations of withLightVariations(). Channels above 255
/// are clipped, as in a sensor. The result is then smoothed equally in all directions by the noise
/// of sensor and compression.
class ColorDensity {
public:
  /// Computes the density of weighted colors. `otherLight` (0 to 1) is the fraction of each color's
  /// weight that is spread as changes in lighting would spread the color.
  ColorDensity(const std::vector<WeightedBgrColor>& colors, double otherLight);

  /// Returns the density in a cell, relative to colors spread evenly over all cells, so that the
  /// mean over all cells is 1. The density is 0 everywhere if no color has any weight.
  double at(std::size_t cell) const { return cells_[cell]; }

private:
  std::vector<double> cells_;
};

} // namespace dewpoint::color
