// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/boxes/target_map.h"

#include <vector>

namespace dewpoint::tracking {

/// Finds boxes of this size that have a large sum of `map` inside, and returns their centers, the
/// largest sum first. Returns at most `most` centers. Every sum is at least `least`, and no two
/// boxes overlap by more than a quarter both horizontally and vertically. Tries the positions on a
/// grid with a spacing of a quarter of the box.
std::vector<Eigen::Vector2d> colorPeaks(const TargetMap& map, double width, double height,
                                        std::size_t most, double least);

} // namespace dewpoint::tracking
