// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::geometry {

/// Function sampled on a grid of the ground plane: values(column, row) belongs to the point origin
/// + step * (column, row). Meters, world x and y.
struct GroundGrid {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  double step = 0.1;
  Eigen::ArrayXXd values;
};

/// Piece of a level curve: points in order, world x and y in meters. The curve is closed if the
/// last point equals the first.
using LevelCurve = std::vector<Eigen::Vector2d>;

/// Returns the curves on which the function equals `level`. The function is interpolated linearly
/// along the grid edges. Method: marching squares (Lorensen & Cline 1987 in two dimensions). If the
/// corners of a grid cell allow two ways to connect the curve (a saddle), the mean of the four
/// corners decides.
std::vector<LevelCurve> levelCurves(const GroundGrid& grid, double level);

/// Returns the level L for which the grid values above L add up to the fraction `probability` of
/// the sum of all values. The curve at this level is the border of the smallest region with this
/// probability. Returns 0 if the sum is zero.
double levelForProbability(const GroundGrid& grid, double probability);

} // namespace dewpoint::geometry
