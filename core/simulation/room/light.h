// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

namespace dewpoint::simulation {

/// The light that the simulated sensors are balanced for, kelvin: daylight, as D55 of CIE 15.
inline constexpr double kBalancedKelvin = 5500.0;

/// What light of `kelvin` gives a sensor that is balanced for kBalancedKelvin, per channel (BGR)
/// and relative to green: Planck's law at one wavelength per channel (460, 540, 620 nm).
Eigen::Vector3d temperatureGain(double kelvin);

} // namespace dewpoint::simulation
