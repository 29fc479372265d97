// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/boxes/target_map.h"

#include <vector>

namespace dewpoint::tracking {

/// Returns the centers of the boxes of this size over which the sums of `map` are largest, the
/// largest first. There are at most `most`, each with a sum of at least `least`, and no two overlap
/// by more than a quarter in both directions. Tries all positions on a grid with a spacing of a
/// quarter of the box.
std::vector<Eigen::Vector2d> colorPeaks(const TargetMap& map, double width, double height,
                                        std::size_t most, double least);

} // namespace dewpoint::tracking
