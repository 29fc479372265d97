// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/boxes/target_map.h"

#include <vector>

namespace dewpoint::tracking {

/// Returns the centers (pixels) of boxes of this size that contain much of the target's colors (a
/// large TargetMap::sum()), the largest sum first. Returns at most `most` centers. Every sum is at
/// least `least`, and no two boxes overlap by more than a quarter both horizontally and vertically.
/// The tested positions form a grid with a spacing of a quarter of the box.
std::vector<Eigen::Vector2d> findColorPeaks(const TargetMap& map, double width, double height,
                                            std::size_t most, double least);

} // namespace dewpoint::tracking
