// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/likelihood/color_cells.h"

#include <cstddef>
#include <vector>

namespace dewpoint::color {

/// Smoothed density of weighted colors in the space of all colors.
///
/// A share of each color's weight is spread as changes of the light would spread it: along the ray
/// through black (brightness), toward gray and away from it (highlights and haze, saturation), and
/// around the gray axis (tint of the light), normally distributed with the standard deviations of
/// inOtherLight(). Channels above 255 are clipped, as in a sensor. The result is then smoothed by
/// the noise of sensor and compression, equally in all directions.
class ColorDensity {
public:
  /// `otherLight`, 0 to 1: share of each color's weight that is spread as in other light.
  ColorDensity(const std::vector<BgrColors>& colors, double otherLight);

  /// Density in a cell, relative to colors spread evenly over all cells: its mean over all cells is
  /// 1. 0 everywhere if nothing has any weight.
  double at(std::size_t cell) const { return cells_[cell]; }

private:
  std::vector<double> cells_;
};

} // namespace dewpoint::color
