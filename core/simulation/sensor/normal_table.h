// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <vector>

namespace dewpoint::simulation {

/// Number of entries in standardNormalNumbers(): 2^16, because 16 random bits select one entry.
inline constexpr std::size_t kNormalCount = 65536;

/// Returns a table of kNormalCount standard normal numbers, which are always the same. Noise is
/// selected at random from this table, because computing new numbers for every pixel would take
/// longer than the rest of a frame.
const std::vector<float>& standardNormalNumbers();

} // namespace dewpoint::simulation
