// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::simulation {

// Camera defaults, chosen for the demo. All results of grade `ideal` were measured with these
// defaults.

/// Default frame rate of simulated cameras, in frames per second. Nearly all webcams support it.
inline constexpr double kDefaultFrameRate = 30.0;
/// Default exposure time of simulated cameras in seconds, typical of a webcam in a well-lit room. A
/// ball at 1 m/s, half a meter away, is blurred over 7 pixels at a focal length of 350 pixels.
inline constexpr double kDefaultExposureSeconds = 0.01;
/// Default standard deviation of the simulated sensor noise, gray levels. Real values range from
/// about 1 in sunlight to 8 in darkness.
inline constexpr double kDefaultNoiseSigma = 3.0;

} // namespace dewpoint::simulation
