// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_coverage.h"
#include "core/calibration/board/view_fit.h"
#include "core/geometry/camera.h"

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Returns the beginning of a self-contained HTML page up to its body, with the styles for the
/// drawings of a report.
std::string htmlHead(const std::string& title);
/// Width of the widest drawings, in SVG units. Origin not recorded.
inline constexpr double kDrawingWidth = 460.0;

inline constexpr const char* kPageEnd = "</body></html>\n";

/// Observed image point, and its displacement from the projection.
struct ImageResidual {
  Eigen::Vector2d pixel;    ///< measured position
  Eigen::Vector2d residual; ///< measured minus projected, pixels
};

/// Returns an SVG with the outline of an image and an arrow for each residual, from the projected
/// to the measured pixel. The arrows are enlarged so that typical residuals are visible. The scale
/// is shown next to the image.
std::string residualDrawing(const Intrinsics& image, const std::vector<ImageResidual>& residuals);

/// Returns an SVG with the number of corners in each region of the image, and notes next to it.
std::string coverageDrawing(const Intrinsics& image, const BoardCoverage& coverage,
                            const std::vector<std::string>& notes);

/// Returns an SVG with a bar for the error of each image. Images that were left out are hatched.
std::string viewErrorDrawing(const std::vector<ViewFit>& views);

} // namespace dewpoint::calibration
