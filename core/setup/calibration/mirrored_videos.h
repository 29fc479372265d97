// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/board_search.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Cameras that show a ChArUco board mirrored left to right, and the cause: a mirrored video or a
/// mirrored board. A chessboard looks the same in a mirrored image, so it cannot reveal a mirrored
/// video.
struct MirroredVideos {
  enum class Cause {
    None,   ///< no camera shows a mirrored board
    Videos, ///< the videos of `mirroredCameras`: another camera shows the board as it is
    /// The videos of `mirroredCameras` or the board: no camera shows the board as it is.
    BoardOrVideos,
  };
  Cause cause = Cause::None;
  /// Indices, in the project, of the cameras that show a mirrored board.
  std::vector<std::size_t> mirroredCameras;

  bool operator==(const MirroredVideos&) const = default;
};

/// Counts the images (CV_8UC1 or CV_8UC3, BGR) that show a board as it is, and those that show it
/// mirrored.
MirroringCounts countMirroredImages(const BoardDescription& board,
                                    const std::vector<cv::Mat>& images);

/// Returns which videos are mirrored. A camera shows a mirrored board if at least three of its
/// images do, and none shows the board as it is.
MirroredVideos mirroredVideos(const std::vector<MirroringCounts>& cameras);
/// Returns which videos are mirrored, according to a search for the board. A camera that saw the
/// board as it is in any frame is not mirrored.
MirroredVideos mirroredVideos(const BoardDetections& seen);
/// Returns which videos are mirrored, according to `frames` evenly spaced frames of a recording.
/// Returns Cause::None for a chessboard. Returns BadValue if the cameras are live, Canceled, or the
/// errors of the source.
Result<MirroredVideos> findMirroredVideos(FrameSetSource& source, const BoardDescription& board,
                                          int frames = kBoardProposalFrames,
                                          const CalibrationProgress& progress = {});

/// Returns a sentence that names the mirrored videos. `names` contains the names of all cameras.
/// The sentence is empty if no video is mirrored.
std::string mirroredText(const MirroredVideos& mirrored, const std::vector<std::string>& names);

/// Returns the project with the images of these cameras mirrored (see withImageSymmetry()), except
/// for simulated cameras.
Project withUnmirroredVideos(Project project, const MirroredVideos& mirrored);

} // namespace dewpoint::setup
