// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/boxes/target_map.h"

#include <vector>

namespace dewpoint::tracking {

/// Centers of the boxes of one size that hold most of the target's colors, the best first: at most
/// `most` of them, no two overlapping by more than a quarter in each direction, each with a sum of
/// at least `least`. All positions on a grid of a quarter of the box are tried.
std::vector<Eigen::Vector2d> colorPeaks(const TargetMap& map, double width, double height,
                                        std::size_t most, double least);

} // namespace dewpoint::tracking
