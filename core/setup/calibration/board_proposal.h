// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/board_search.h"

#include <filesystem>
#include <vector>

namespace dewpoint::setup {

/// Finds out which boards a recording shows, most likely first, from `frames` evenly spaced frames.
/// See guessBoards(). Returns NotFound if there is none, BadValue if the cameras are live,
/// Canceled, or the errors of the source.
Result<std::vector<BoardGuess>> proposeBoards(FrameSetSource& source,
                                              const BoardDescription& requested,
                                              int frames = kFramesToLookAt,
                                              const CalibrationProgress& progress = {});
/// Finds out which boards image files show, from at most `count` of them. Returns NotFound if there
/// is none, FileMissing, FileUnreadable, or Canceled.
Result<std::vector<BoardGuess>> proposeBoards(const std::vector<std::filesystem::path>& pictures,
                                              const BoardDescription& requested,
                                              int count = kFramesToLookAt,
                                              const CalibrationProgress& progress = {});
/// Finds out which boards the images of one time show. Returns NotFound or Canceled.
Result<std::vector<BoardGuess>> proposeBoards(const FrameSet& frames,
                                              const BoardDescription& requested,
                                              const CalibrationProgress& progress = {});

} // namespace dewpoint::setup
