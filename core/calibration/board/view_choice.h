// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/view_fit.h"

#include <vector>

namespace dewpoint::calibration {

/// Selects views of one camera for a calibration: at most `count` sharp views that differ as much
/// as possible in position, size and tilt (farthest point sampling, Gonzalez 1985). Returns all
/// views if there are no more than `count`. Preserves the order.
std::vector<BoardView> chooseViews(const BoardDescription& board, std::vector<BoardView> views,
                                   int width, int height, int count);

/// Selects views of several cameras in the same way. Keeps the views from at most `count` instants
/// at which at least two cameras saw the board sharply, plus all views from the instant `always`.
std::vector<std::vector<BoardView>> chooseInstants(const std::vector<std::vector<BoardView>>& views,
                                                   const std::vector<int>& widths, int count,
                                                   std::optional<std::int64_t> always);

} // namespace dewpoint::calibration
