// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/extrinsics_from_board.h"
#include "core/calibration/board/intrinsics_from_board.h"
#include "core/calibration/report/board_report.h"
#include "core/capture/frame_source.h"
#include "core/project/project.h"
#include "core/setup/calibrated_project.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// What is wanted of a calibration from a board.
struct BoardCalibrationRequest {
  BoardDescription board;
  IntrinsicsModel model = IntrinsicsModel::FiveCoefficients;
  PixelShape pixels = PixelShape::Measured;
  int views = 30;       ///< pictures per camera that intrinsics are estimated from
  int instants = 60;    ///< instants that poses are estimated from
  int frameLimit = 300; ///< frames of a recording in which the board is searched for
  /// The frame in which the board lies on the floor and makes the world; nothing: the first camera
  /// keeps its pose.
  std::optional<std::int64_t> worldFrame;
  bool refineIntrinsics = false; ///< adjust the lenses with the poses
};

/// Where the cameras of a recording, or a set of pictures of one camera, saw the board.
struct SeenBoards {
  struct PerCamera {
    std::string name;
    int width = 0;
    int height = 0;
    int searched = 0; ///< pictures in which it was searched for
    std::vector<BoardView> views;
  };
  std::vector<PerCamera> cameras;
  double framesPerSecond = 30.0;
};

/// Looks for the board in a recording, in frames spread over it evenly; all cameras at the same
/// ones. BadValue when the cameras are live, Cancelled, and what the source says.
Result<SeenBoards> findBoards(const Project& project, FrameSetSource& source,
                              const BoardCalibrationRequest& request,
                              const CalibrationProgress& progress = {});

/// Looks for the board in picture files of one camera; views are named by their file's name.
/// FileUnreadable, Mismatch when sizes differ, Cancelled.
Result<SeenBoards> findBoards(const std::vector<std::filesystem::path>& pictures,
                              const BoardDescription& board, DetectionEffort effort,
                              const CalibrationProgress& progress = {});

/// The lenses that were found, and why others were not.
struct LensesFromBoards {
  std::vector<std::optional<IntrinsicsResult>> cameras; ///< nothing: it keeps its lens
  std::vector<Error> kept; ///< for each camera that keeps its lens: its name (field), and why
};

/// The intrinsics of each camera of `seen`, from views chosen by chooseViews(). A camera that did
/// not see the board well keeps its lens; the error, which names the camera, is returned when that
/// is so of all of them, and Cancelled.
Result<LensesFromBoards> intrinsicsFromBoards(const SeenBoards& seen,
                                              const BoardCalibrationRequest& request,
                                              const CalibrationProgress& progress = {});

/// The poses of a project's cameras, with the intrinsics it has, from instants chosen by
/// chooseInstants(). Cameras that never saw the board keep their poses and are named in the
/// notices, as long as two others saw it; if the first is one of them, the first that saw it keeps
/// its pose instead. Faults that explain what is seen better are named in the result, or in the
/// error.
Result<ExtrinsicsResult> extrinsicsFromBoards(const Project& project, const SeenBoards& seen,
                                              const BoardCalibrationRequest& request,
                                              const CalibrationProgress& progress = {});

/// "camera 2 keeps its lens: it never saw the board, in 60 pictures".
std::string keptSentence(const Error& kept);

/// The report on intrinsics.
BoardReport reportOf(const SeenBoards& seen, const BoardCalibrationRequest& request,
                     const LensesFromBoards& lenses);

} // namespace dewpoint::setup
