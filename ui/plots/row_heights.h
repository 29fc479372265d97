// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <vector>

namespace dewpoint::ui {

/// Returns the heights of the rows in a scrolled stack such that no row is cut off when the stack
/// is scrolled to either end: the first rows together, and the last rows together, are exactly
/// `visible` high. No row is lower than its minimum height in `least`. Returns an empty list if all
/// rows fit without scrolling. If not even the first row fits, each row gets its minimum height.
/// All heights are in pixels.
std::vector<int> heightsForWholeRows(const std::vector<int>& least, int visible);

} // namespace dewpoint::ui
