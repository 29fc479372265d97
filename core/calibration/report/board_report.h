// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/extrinsics_from_board.h"
#include "core/calibration/board/intrinsics_from_board.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Content of a calibration report page.
struct BoardReport {
  struct CameraPart {
    std::string name;
    Camera camera;
    double rmsPx = 0.0;
    BoardCoverage coverage;
    std::vector<ViewFit> views;
    /// Estimated intrinsics; empty if the intrinsics were given.
    std::vector<EstimatedParameter> parameters;
    /// Largest standard deviation of the projection of a ray, pixels.
    std::optional<double> projectionSigmaPx;
    /// Standard deviation of the camera's position, meters; empty unless poses were estimated.
    std::optional<double> centerSigma;
    /// Standard deviation of the camera's orientation, radians; empty unless poses were estimated.
    std::optional<double> rotationSigma;
  };

  std::string title;
  BoardDescription board;
  std::vector<CameraPart> cameras;
  /// Board poses for the 3D plot; there is no plot without poses.
  std::vector<BoardPose> boardPoses;
  std::vector<std::string> notices;
  std::string accuracyText; ///< one sentence about the accuracy of the calibration; may be empty
};

/// Returns the report section about one camera's intrinsics.
BoardReport::CameraPart reportPartOf(const std::string& name, const IntrinsicsResult& result);

/// Returns the report about the poses of all cameras.
BoardReport reportOf(const BoardDescription& board, const ExtrinsicsResult& result);

/// Returns the report as a self-contained HTML page. For each camera, the page shows results,
/// residual arrows, coverage and the errors of all images. It also shows the cameras and the board
/// poses in space.
std::string htmlText(const BoardReport& report);
/// Returns several reports on one page, one below the other. `reports` must not be empty.
std::string htmlText(const std::vector<BoardReport>& reports);

} // namespace dewpoint::calibration
