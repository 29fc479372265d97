// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/extrinsics_from_board.h"
#include "core/calibration/report/board_report.h"
#include "core/project/project.h"
#include "core/setup/calibration/board_search.h"
#include "core/setup/calibration/calibrated_project.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Intrinsics estimated from views of a board. If the intrinsics of a camera were not estimated,
/// `keptIntrinsicsReasons` contains the reason.
struct LensesFromBoards {
  /// Result for each camera; empty: the camera keeps its intrinsics.
  std::vector<std::optional<IntrinsicsResult>> cameras;
  /// For each camera that keeps its intrinsics, an error with the name of the camera (Error::field)
  /// and the reason.
  std::vector<Error> keptIntrinsicsReasons;
};

/// Estimates the intrinsics of each camera in `seen` from views chosen by chooseViews(). A camera
/// that did not see the board well enough keeps its intrinsics. If no camera saw the board well
/// enough, returns the error of one camera, which names this camera. If only another board was
/// seen, returns NotFound with the description of that board. Returns Canceled if `progress`
/// canceled the work.
Result<LensesFromBoards> intrinsicsFromBoards(const BoardDetections& seen,
                                              const BoardCalibrationRequest& request,
                                              const CalibrationProgress& progress = {});

/// Estimates the poses of a project's cameras with their current intrinsics, from frames chosen by
/// chooseInstants(). If at least two cameras saw the board, those that never saw it keep their
/// poses and are named in the notices. Unless the request names a `floorFrame`, the first camera
/// that saw the board keeps its pose, as the reference for the others. If only another board was
/// seen, returns NotFound with its description. If a known fault, such as exchanged cameras,
/// explains the detections better than the given project does, the result or the error names the
/// fault.
Result<ExtrinsicsResult> extrinsicsFromBoards(const Project& project, const BoardDetections& seen,
                                              const BoardCalibrationRequest& request,
                                              const CalibrationProgress& progress = {});

/// Returns a sentence about a camera that keeps its intrinsics, like "camera 2 keeps its
/// intrinsics: it never saw the board in 60 images".
std::string keptIntrinsicsText(const Error& kept);

/// Creates the report on the intrinsics of cameras that were estimated from views of a board.
BoardReport reportOf(const BoardDetections& seen, const BoardCalibrationRequest& request,
                     const LensesFromBoards& lenses);

} // namespace dewpoint::setup
