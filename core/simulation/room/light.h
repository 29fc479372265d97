// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::simulation {

/// Color temperature in kelvin for which the simulated sensors are balanced, so that white looks
/// white: daylight, like the illuminant D55 of CIE 15.
inline constexpr double kBalancedKelvin = 5500.0;

/// Returns how strongly each channel (BGR) of a sensor responds to light of color temperature
/// `kelvin`, relative to green. For kBalancedKelvin, all values are 1. Method: Planck's law at one
/// wavelength per channel (460, 540, 620 nm).
Eigen::Vector3d colorTemperatureGain(double kelvin);

} // namespace dewpoint::simulation
