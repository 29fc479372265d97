// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::simulation {

/// Color temperature for which the simulated sensors are balanced, in kelvin: daylight, like D55 of
/// CIE 15.
inline constexpr double kBalancedKelvin = 5500.0;

/// Returns the response of a sensor balanced for kBalancedKelvin to light with color temperature
/// `kelvin`, per channel (BGR) and relative to green. It follows Planck's law at one wavelength per
/// channel (460, 540, 620 nm).
Eigen::Vector3d temperatureGain(double kelvin);

} // namespace dewpoint::simulation
