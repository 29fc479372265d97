// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/view_fit.h"

#include <vector>

namespace dewpoint::calibration {

/// Returns at most `count` views of one camera for a calibration, in their original order. They
/// differ as much as possible in position, size and tilt (farthest point sampling, Gonzalez 1985).
/// Sharp views are preferred if there are enough of them. If there are no more than `count` views,
/// returns all of them. `width` and `height`: image size, pixels.
std::vector<BoardView> chooseViews(const BoardDescription& board, std::vector<BoardView> views,
                                   int width, int height, int count);

/// Returns views of several cameras for a calibration. Chooses at most `count` instants
/// (BoardView::instant) at which at least two cameras saw the board sharply, and keeps the sharp
/// views of these instants. The instants differ as much as possible, as in chooseViews(). Also
/// keeps all views of the instant `always`. `widths`: image width of each camera, pixels.
std::vector<std::vector<BoardView>> chooseInstants(const std::vector<std::vector<BoardView>>& views,
                                                   const std::vector<int>& widths, int count,
                                                   std::optional<std::int64_t> always);

} // namespace dewpoint::calibration
