// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/board_search.h"

#include <filesystem>
#include <vector>

namespace dewpoint::setup {

/// Returns the boards that a recording probably shows, the most likely one first. Only `frames`
/// evenly spaced frames are searched. `requested` is the board that the user expects. It provides
/// what images do not show, such as the square size (guessBoards()). Errors: NotFound if no board
/// is found; BadValue if the cameras are live; Canceled; the errors of the source.
Result<std::vector<BoardGuess>> proposeBoards(FrameSetSource& source,
                                              const BoardDescription& requested,
                                              int frames = kBoardProposalFrames,
                                              const CalibrationProgress& progress = {});
/// Returns the boards that image files probably show, the most likely one first. At most `count` of
/// the files are searched. `requested` is the board that the user expects. Errors: NotFound if no
/// board is found; FileMissing; FileUnreadable; Canceled.
Result<std::vector<BoardGuess>> proposeBoards(const std::vector<std::filesystem::path>& pictures,
                                              const BoardDescription& requested,
                                              int count = kBoardProposalFrames,
                                              const CalibrationProgress& progress = {});
/// Returns the boards that the images of one frame probably show, the most likely one first.
/// `requested` is the board that the user expects. Errors: NotFound if no board is found; Canceled.
Result<std::vector<BoardGuess>> proposeBoards(const FrameSet& frames,
                                              const BoardDescription& requested,
                                              const CalibrationProgress& progress = {});

} // namespace dewpoint::setup
