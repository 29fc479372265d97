// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_detection.h"
#include "core/calibration/board/board_guess.h"
#include "core/calibration/board/board_miss.h"
#include "core/calibration/board/intrinsics_from_board.h"
#include "core/capture/frame_source.h"
#include "core/project/project.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Options of a calibration with a board.
struct BoardCalibrationRequest {
  BoardDescription board;
  IntrinsicsModel model = IntrinsicsModel::FiveCoefficients;
  PixelShape pixelShape = PixelShape::Measured;
  int maxViews = 30;    ///< number of images per camera used to estimate intrinsics
  int maxInstants = 60; ///< number of frames used to estimate poses
  int maxSearchedFrames =
      300; ///< maximum number of frames of a recording that are searched for the board
  std::int64_t firstFrame = 0; ///< first frame in which the board may be searched for
  /// One past the last frame in which the board may be searched for; not set: up to the end.
  std::optional<std::int64_t> endFrame;
  /// Frame in which the board lies on the floor and defines the world frame; not set: the first
  /// camera keeps its pose.
  std::optional<std::int64_t> floorFrame;
  bool refinesIntrinsics = false; ///< true to refine the intrinsics together with the poses
  /// True to search a few frames of a long recording first. If these show only another board than
  /// the requested one, the remaining frames are not searched.
  bool checksForOtherBoardFirst = true;
};

/// Image in which the board was not found.
struct MissedImage {
  std::string file;        ///< name of an image file; empty for a frame of a recording
  std::int64_t number = 0; ///< number of the frame, or of the file in its list; counts from 0
  /// Reason why the board was not found, if it is known. It is determined only for image files and
  /// short recordings, and only for a few images of each camera.
  BoardMiss missReason;
};

/// Numbers of images of a camera in which a board is found as it is, or only after the image is
/// mirrored.
struct MirroringCounts {
  int unmirroredCount = 0; ///< number of images that show the board as it is
  int mirroredCount = 0;   ///< number of images that show it after they are mirrored left to right
};

/// Board detections in the recording of several cameras, or in a set of images of one camera.
struct BoardDetections {
  struct PerCamera {
    std::string name;
    int imageWidth = 0;
    int imageHeight = 0;
    int searchedImageCount = 0; ///< number of images in which the board was searched for
    std::vector<BoardView> views;
    /// Other board that was found in a few of this camera's images. Set only if this camera never
    /// saw the requested board but other cameras did.
    std::optional<BoardGuess> otherBoard = std::nullopt;
    std::vector<MissedImage> missedImages = {}; ///< the images without the board, in order
    /// Numbers of images with the board as it is and mirrored, from a few images of this camera.
    /// Set only if some images show a mirrored board.
    MirroringCounts mirroringCounts = {};
  };
  std::vector<PerCamera> cameras;
  double framesPerSecond = 30.0;
  /// Other board that was found in a few images of all cameras. Set only if none, or almost none,
  /// of the images show the requested board.
  std::optional<BoardGuess> otherBoard = std::nullopt;
  /// False if the search ended after a few frames, because these show only another board.
  bool hasSearchedAllFrames = true;

  /// Returns whether the images show only another board than the requested one.
  bool hasOnlyOtherBoard() const;
  /// Returns the other board that a camera saw, if any; null otherwise.
  const BoardGuess* otherBoardSeenBy(const PerCamera& camera) const;
};

/// Searches a recording for the board, in evenly spaced frames that are the same for all cameras.
/// Only frames from `firstFrame` to before `endFrame` are searched, and in addition `floorFrame`.
/// With `checksForOtherBoardFirst`, a few frames of a long recording are searched first: if they
/// show another board instead of the requested one, the search ends and returns the other board
/// (`otherBoard`). If a camera never sees the board, a few of its images are searched for any
/// board. Returns BadValue if the cameras are live or if the recording has none of these frames.
/// Also returns Canceled, or the errors of the source.
Result<BoardDetections> findBoards(const Project& project, FrameSetSource& source,
                                   const BoardCalibrationRequest& request,
                                   const CalibrationProgress& progress = {});

/// Searches image files from one camera for the board. `effort` is the thoroughness of the search.
/// With `checksForOtherBoardFirst`, a few of many files are searched first; if they show only
/// another board than the requested one, the search ends. Each view is named after its file.
/// Returns FileUnreadable, Mismatch if the image sizes differ, or Canceled.
Result<BoardDetections> findBoards(const std::vector<std::filesystem::path>& pictures,
                                   const BoardDescription& board, DetectionEffort effort,
                                   const CalibrationProgress& progress = {},
                                   bool checksForOtherBoardFirst = true);

/// Number of frames that are searched to find out which board a recording shows.
inline constexpr int kBoardProposalFrames = 12;

} // namespace dewpoint::setup
