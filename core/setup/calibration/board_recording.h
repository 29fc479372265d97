// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/board_outcome.h"
#include "core/setup/calibration/board_proposal.h"
#include "core/setup/calibration/mirrored_videos.h"

#include <optional>
#include <vector>

namespace dewpoint::setup {

/// Calibration from the recording of a board. What the search found in the images is known even if
/// the calibration failed, because it may explain the failure.
struct BoardRecordingCalibration {
  Result<BoardOutcome> outcome;
  /// Other board that was seen instead; see BoardDetections.
  std::optional<BoardGuess> otherBoard = std::nullopt;
  bool hasSearchedAllFrames = true; ///< see BoardDetections
  MirroredVideos mirroredVideos = {};
};

/// Searches a recording for the board, determines which videos are mirrored, and calibrates from
/// the detections. The outcome is that of calibrateFromBoards(); its errors are those of the search
/// (findBoards()), such as Canceled, and of the calibration.
BoardRecordingCalibration calibrateFromBoardRecording(const Project& project,
                                                      FrameSetSource& source,
                                                      const BoardCalibrationRequest& request,
                                                      const BoardGoal& goal,
                                                      const CalibrationProgress& progress = {});

/// Boards that a recording probably shows, and which of its videos are mirrored.
struct BoardRecordingProposal {
  std::vector<BoardGuess> guesses; ///< the most likely board first; never empty
  /// The videos that show the most likely board mirrored, or the reason why this is not known. The
  /// boards are of use without it, so its error is not that of the proposal.
  Result<MirroredVideos> mirroredVideos;
};

/// Proposes boards for a recording (proposeBoards()), and determines which videos show the most
/// likely one mirrored (findMirroredVideos()). Both search the same `frames` evenly spaced frames.
/// Errors are those of proposeBoards().
Result<BoardRecordingProposal>
proposeBoardsAndMirroredVideos(FrameSetSource& source, const BoardDescription& requested,
                               int frames = kBoardProposalFrames,
                               const CalibrationProgress& progress = {});

} // namespace dewpoint::setup
