// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_report.h"

#include <string>

namespace dewpoint {

/// An image's outline with an arrow per corner from where it is projected to where it was measured,
/// lengthened so that the longest usual ones can be seen, with the scale beside it. SVG.
std::string residualDrawing(const BoardReport::CameraPart& camera);

/// Corners seen in each region of the image, and views at each tilt. SVG.
std::string coverageDrawing(const BoardReport::CameraPart& camera);

/// The error of each picture as a bar; those left out are hatched. SVG.
std::string errorDrawing(const BoardReport::CameraPart& camera);

/// Cameras and boards in space: from the side above, and from above. SVG.
std::string spaceDrawing(const BoardReport& report);

} // namespace dewpoint
