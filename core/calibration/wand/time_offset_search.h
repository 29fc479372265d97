// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/wand/wand_calibration.h"

#include <vector>

namespace dewpoint::calibration {

/// How the cameras' clocks stand against the first one's, to about half a frame: seconds to add to
/// the times of a camera's views, as in WandResult::offsets. Offsets up to half a second either way
/// are tried; 0 where the views do not determine one.
///
/// With the right offset the rays of two cameras to the moving ball miss each other only because
/// the cameras stand roughly: by something that changes smoothly with the position (a polynomial of
/// second order is taken). With a wrong one they miss by the ball's way meanwhile, too. So the
/// offset is taken that leaves the least beyond such a polynomial.
std::vector<double> searchTimeOffsets(const WandProblem& problem);

/// The views at other times: these seconds are added to those of each camera.
std::vector<std::vector<MarkerObservation>>
shiftedInTime(std::vector<std::vector<MarkerObservation>> views,
              const std::vector<double>& offsets);

} // namespace dewpoint::calibration
