// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::geometry {

/// A function sampled on a grid of the ground plane: values(column, row) is that of the point
/// origin + step * (column, row). Meters, world x and y.
struct GroundGrid {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  double step = 0.1;
  Eigen::ArrayXXd values;
};

/// One piece of a level curve: points in order; closed when the last equals the first.
using LevelCurve = std::vector<Eigen::Vector2d>;

/// Where the function, linear along the edges of the grid, has this value (marching squares:
/// Lorensen & Cline 1987 in two dimensions; a saddle is cut by the mean of its four corners).
std::vector<LevelCurve> levelCurves(const GroundGrid& grid, double level);

/// The value above which lies the share `probability` of the sum of all values (the border of the
/// smallest region that holds it); 0 when there is nothing.
double levelHolding(const GroundGrid& grid, double probability);

} // namespace dewpoint::geometry
