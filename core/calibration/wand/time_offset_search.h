// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/wand/wand_calibration.h"

#include <vector>

namespace dewpoint::calibration {

/// Estimates the time offsets of the cameras relative to the first one, to about half a frame. An
/// offset is the number of seconds to add to the times of a camera's views, as in
/// WandResult::timeOffsets. Offsets of up to half a second in both directions are tried. If the
/// views do not determine an offset, it is 0.
///
/// With the correct offset, the rays of two cameras to the moving ball miss each other only because
/// the poses are approximate. The distance between the rays changes smoothly with the position and
/// is modeled by a second-order polynomial. With a wrong offset, the rays also miss each other
/// because the ball has moved in the meantime. The result is the offset for which the residual of
/// such a polynomial is smallest.
std::vector<double> searchTimeOffsets(const WandProblem& problem);

/// Returns the views with each camera's offset (seconds) added to their times.
std::vector<std::vector<MarkerObservation>>
shiftedInTime(std::vector<std::vector<MarkerObservation>> views,
              const std::vector<double>& offsets);

} // namespace dewpoint::calibration
