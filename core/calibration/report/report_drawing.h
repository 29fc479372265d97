// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_coverage.h"
#include "core/calibration/board/view_fit.h"
#include "core/geometry/camera.h"

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// The beginning of a self-contained HTML page, up to its body; styles for the drawings below.
std::string pageHead(const std::string& title);
/// Width of the widest drawings, SVG units. Origin not recorded.
inline constexpr double kDrawingWidth = 460.0;

inline constexpr const char* kPageEnd = "</body></html>\n";

/// Something seen in an image, and how far it is from where it is projected.
struct ImageResidual {
  Eigen::Vector2d pixel;    ///< as measured
  Eigen::Vector2d residual; ///< measured less projected, pixels
};

/// An image's outline with an arrow per residual from where it is projected to where it was
/// measured, lengthened so that the longest usual ones can be seen, with the scale beside it. SVG.
std::string residualDrawing(const Intrinsics& image, const std::vector<ImageResidual>& residuals);

/// What was seen in each region of the image, and notes beside it. SVG.
std::string coverageDrawing(const Intrinsics& image, const BoardCoverage& coverage,
                            const std::vector<std::string>& notes);

/// The error of each picture as a bar; those left out are hatched. SVG.
std::string errorDrawing(const std::vector<ViewFit>& views);

} // namespace dewpoint::calibration
