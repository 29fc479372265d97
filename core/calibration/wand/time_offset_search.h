// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/wand/wand_calibration.h"

#include <vector>

namespace dewpoint::calibration {

/// Estimates the time offsets of the cameras relative to the first one, to about half a frame:
/// seconds to add to the times of a camera's views, as in WandResult::offsets. Offsets of up to
/// half a second in both directions are tried; 0 if the views do not determine an offset.
///
/// With the correct offset, the rays of two cameras to the moving ball miss each other only because
/// the poses are approximate; this distance changes smoothly with the position (it is modeled by a
/// polynomial of second order). With a wrong offset they also miss each other by the motion of the
/// ball in the meantime. The result is the offset for which the residual of such a polynomial is
/// smallest.
std::vector<double> searchTimeOffsets(const WandProblem& problem);

/// Returns the views with these seconds added to the times of each camera.
std::vector<std::vector<MarkerObservation>>
shiftedInTime(std::vector<std::vector<MarkerObservation>> views,
              const std::vector<double>& offsets);

} // namespace dewpoint::calibration
