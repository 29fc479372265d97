// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/likelihood/color_cells.h"

#include <cstddef>
#include <vector>

namespace dewpoint::color {

/// How densely weighted colors lie in the space of all colors, smoothed as colors vary.
///
/// A share of each color is spread as light changes it: along its ray through black (brightness),
/// toward gray and away from it (highlights and haze, fullness), and around the gray axis (tint of
/// the light), normally distributed with the standard deviations of inOtherLight(). A channel that
/// would exceed 255 is cut off, as a sensor does. All of it is then spread by the noise of sensor
/// and compression, the same in all directions.
class ColorDensity {
public:
  /// `otherLight`, 0 to 1: the share of each color's weight that is spread as in other light.
  ColorDensity(const std::vector<BgrColors>& colors, double otherLight);

  /// In a cell, relative to colors spread evenly over all cells: the mean over the cells is 1; 0
  /// everywhere if nothing has any weight.
  double at(std::size_t cell) const { return cells_[cell]; }

private:
  std::vector<double> cells_;
};

} // namespace dewpoint::color
