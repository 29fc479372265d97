// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <vector>

namespace dewpoint::ui {

/// Returns heights for a stack of rows that does not fit into `visible` pixels, so that no row is
/// cut at either end of the stack: the first rows fill the visible height exactly while the stack
/// is not scrolled, and the last rows when it is scrolled to its end. No row gets less than its
/// minimum height in `least`. Returns an empty list if all rows fit. If not even the first row
/// fits, each row gets its minimum height. All heights are in pixels.
std::vector<int> wholeRowHeights(const std::vector<int>& least, int visible);

} // namespace dewpoint::ui
