// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/extrinsics_from_board.h"
#include "core/calibration/board/intrinsics_from_board.h"
#include "core/calibration/report/board_report.h"
#include "core/capture/frame_source.h"
#include "core/project/project.h"
#include "core/setup/calibration/calibrated_project.h"

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
  PixelShape pixels = PixelShape::Measured;
  int views = 30;              ///< images per camera used to estimate intrinsics
  int instants = 60;           ///< instants used to estimate poses
  int frameLimit = 300;        ///< frames of a recording in which the board is searched for
  std::int64_t firstFrame = 0; ///< first frame in which the board may be searched for
  std::optional<std::int64_t> endFrame; ///< one past the last such frame; not set: all
  /// Frame in which the board lies on the floor and defines the world frame; not set: the first
  /// camera keeps its pose.
  std::optional<std::int64_t> worldFrame;
  bool refineIntrinsics = false; ///< refine the intrinsics together with the poses
};

/// Board detections in the recording of several cameras, or in a set of images of one camera.
struct BoardDetections {
  struct PerCamera {
    std::string name;
    int width = 0;
    int height = 0;
    int searched = 0; ///< number of images in which the board was searched for
    std::vector<BoardView> views;
  };
  std::vector<PerCamera> cameras;
  double framesPerSecond = 30.0;
};

/// Searches a recording for the board, in evenly spaced frames that are the same for all cameras.
/// Only the frames from `firstFrame` to `endFrame` count, and `worldFrame` wherever it is. Returns
/// BadValue if the cameras are live or there is no such frame, Canceled, or the errors of the
/// source.
Result<BoardDetections> findBoards(const Project& project, FrameSetSource& source,
                                   const BoardCalibrationRequest& request,
                                   const CalibrationProgress& progress = {});

/// Searches image files from one camera for the board. Each view is named after its file. Returns
/// FileUnreadable, Mismatch if the image sizes differ, or Canceled.
Result<BoardDetections> findBoards(const std::vector<std::filesystem::path>& pictures,
                                   const BoardDescription& board, DetectionEffort effort,
                                   const CalibrationProgress& progress = {});

/// Estimated intrinsics, and the reasons why those of other cameras were not estimated.
struct LensesFromBoards {
  std::vector<std::optional<IntrinsicsResult>> cameras; ///< empty: the camera keeps its intrinsics
  /// For each camera that keeps its intrinsics: its name (field), and the reason.
  std::vector<Error> kept;
};

/// Estimates the intrinsics of each camera in `seen` from views chosen by chooseViews(). A camera
/// that did not see the board well keeps its intrinsics. If this applies to all cameras, returns
/// the error, which names the camera. Returns Canceled if `progress` canceled the work.
Result<LensesFromBoards> intrinsicsFromBoards(const BoardDetections& seen,
                                              const BoardCalibrationRequest& request,
                                              const CalibrationProgress& progress = {});

/// Estimates the poses of a project's cameras with their present intrinsics, from instants chosen
/// by chooseInstants(). Cameras that never saw the board keep their poses and are named in the
/// notices, if at least two others saw it. If the first camera is one of them, the first that saw
/// the board keeps its pose instead. Faults that explain the detections better are named in the
/// result, or in the error.
Result<ExtrinsicsResult> extrinsicsFromBoards(const Project& project, const BoardDetections& seen,
                                              const BoardCalibrationRequest& request,
                                              const CalibrationProgress& progress = {});

/// Returns a sentence like "camera 2 keeps its intrinsics: it never saw the board in 60 images".
std::string keptIntrinsicsText(const Error& kept);

/// Returns the report on intrinsics.
BoardReport reportOf(const BoardDetections& seen, const BoardCalibrationRequest& request,
                     const LensesFromBoards& lenses);

} // namespace dewpoint::setup
