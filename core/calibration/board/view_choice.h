// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/view_fit.h"

#include <vector>

namespace dewpoint::calibration {

/// The views of one camera that are worth a calibration: at most `count`, sharp, and as different
/// from each other in position, size and tilt as possible (farthest point sampling, Gonzalez 1985).
/// All of them when they are not more. In their former order.
std::vector<BoardView> chooseViews(const BoardDescription& board, std::vector<BoardView> views,
                                   int width, int height, int count);

/// Of several cameras' views, those of at most `count` instants at which two cameras at least saw
/// the board sharply, chosen likewise; and of the instant `always`, whoever saw it.
std::vector<std::vector<BoardView>> chooseInstants(const std::vector<std::vector<BoardView>>& views,
                                                   const std::vector<int>& widths, int count,
                                                   std::optional<std::int64_t> always);

} // namespace dewpoint::calibration
