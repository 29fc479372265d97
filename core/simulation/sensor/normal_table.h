// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <vector>

namespace dewpoint::simulation {

/// Entries of normalTable(): as many as 16 random bits choose between.
inline constexpr std::size_t kNormalCount = 65536;

/// Standard normal numbers to pick from at random: drawing them again for every pixel would cost
/// more than all the rest of a frame. Always the same ones.
const std::vector<float>& normalTable();

} // namespace dewpoint::simulation
