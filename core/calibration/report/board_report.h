// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/extrinsics_from_board.h"
#include "core/calibration/board/intrinsics_from_board.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Content of the report page of a calibration.
struct BoardReport {
  struct CameraPart {
    std::string name;
    Camera camera;
    double rmsPx = 0.0;
    BoardCoverage coverage;
    std::vector<ViewFit> views;
    std::vector<EstimatedParameter> parameters; ///< empty if intrinsics were given
    std::optional<double> projectionPx;         ///< IntrinsicsResult::worstProjectionPx
    std::optional<double> centerSigma;          ///< meters, if poses were estimated
    std::optional<double> turnSigma;            ///< radians
  };

  std::string title;
  BoardDescription board;
  std::vector<CameraPart> cameras;
  std::vector<BoardPose> boardPoses; ///< for the plot in space; without poses there is no plot
  std::vector<std::string> notices;
  std::string accuracy; ///< one sentence; may be empty
};

/// Section of a report about one camera's intrinsics.
BoardReport::CameraPart reportPart(const std::string& name, const IntrinsicsResult& result);

/// Report about the poses of all cameras.
BoardReport reportOf(const BoardDescription& board, const ExtrinsicsResult& result);

/// Report as one self-contained HTML page: results, residual arrows, coverage and errors per image
/// for each camera, and cameras and boards in space.
std::string htmlText(const BoardReport& report);
/// Several reports on one page, one below the other. `reports` must not be empty.
std::string htmlText(const std::vector<BoardReport>& reports);

} // namespace dewpoint::calibration
