// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/extrinsics_from_board.h"
#include "core/calibration/board/intrinsics_from_board.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// What a calibration page shows.
struct BoardReport {
  struct CameraPart {
    std::string name;
    Camera camera;
    double rmsPx = 0.0;
    BoardCoverage coverage;
    std::vector<ViewFit> views;
    std::vector<EstimatedParameter> parameters; ///< empty where intrinsics were given
    std::optional<double> projectionPx;         ///< IntrinsicsResult::worstProjectionPx
    std::optional<double> centerSigma;          ///< meters, where poses were found
    std::optional<double> turnSigma;            ///< radians
  };

  std::string title;
  BoardDescription board;
  std::vector<CameraPart> cameras;
  std::vector<BoardPose> boardPoses; ///< for the plot in space; empty: no plot
  std::vector<std::string> notices;
  std::string accuracy; ///< a sentence; may be empty
};

/// The part of a report about one camera's intrinsics.
BoardReport::CameraPart reportPart(const std::string& name, const IntrinsicsResult& result);

/// The report on all cameras' poses.
BoardReport reportOf(const BoardDescription& board, const ExtrinsicsResult& result);

/// One self-contained HTML page: figures, residual arrows, coverage and errors picture by picture
/// for each camera, and cameras and boards in space.
std::string htmlText(const BoardReport& report);
/// Several reports on one page, one below the other; not empty.
std::string htmlText(const std::vector<BoardReport>& reports);

} // namespace dewpoint::calibration
