// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/board_recording.h"

#include <utility>

namespace dewpoint::setup {

BoardRecordingCalibration calibrateFromBoardRecording(const Project& project,
                                                      FrameSetSource& source,
                                                      const BoardCalibrationRequest& request,
                                                      const BoardGoal& goal,
                                                      const CalibrationProgress& progress) {
  const auto seen = findBoards(project, source, request, progress);
  if (!seen) {
    return {tl::make_unexpected(seen.error())};
  }
  return {calibrateFromBoards(project, *seen, request, goal, progress), seen->otherBoard,
          seen->hasSearchedAllFrames, mirroredVideos(*seen)};
}

Result<BoardRecordingProposal> proposeBoardsAndMirroredVideos(FrameSetSource& source,
                                                              const BoardDescription& requested,
                                                              int frames,
                                                              const CalibrationProgress& progress) {
  return proposeBoards(source, requested, frames, progress)
      .map([&](std::vector<BoardGuess> guesses) {
        auto mirrored = findMirroredVideos(source, guesses.front().board, frames, progress);
        return BoardRecordingProposal{std::move(guesses), std::move(mirrored)};
      });
}

} // namespace dewpoint::setup
