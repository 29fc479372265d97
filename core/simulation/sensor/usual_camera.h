// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::simulation {

// Cameras where nothing else is said. Chosen once for the demo; every figure of grade `ideal` was
// measured with them.

/// Frames per second: what nearly all webcams offer.
inline constexpr double kUsualFrameRate = 30.0;
/// Exposure, seconds: that of a webcam in a well lit room. A ball at 1 m/s, half a meter away, is
/// blurred over 7 pixels of a focal length of 350 pixels.
inline constexpr double kUsualExposure = 0.01;
/// Standard deviation of the sensor noise, gray levels (from about 1 in the sun to 8 in the dark).
inline constexpr double kUsualNoiseSigma = 3.0;

} // namespace dewpoint::simulation
