// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/room/light.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace dewpoint::simulation {

Eigen::Vector3d colorTemperatureGain(double kelvin) {
  constexpr double kSecondRadiation = 0.014388; // h c / k, meter kelvin (CODATA)
  // Meters: about where the blue, green and red pixels of cameras are most sensitive.
  constexpr std::array<double, 3> kWavelengths{460e-9, 540e-9, 620e-9};
  Eigen::Vector3d gain;
  for (int channel = 0; channel < 3; ++channel) {
    const double exponent = kSecondRadiation / kWavelengths.at(static_cast<std::size_t>(channel));
    gain[channel] = std::expm1(exponent / kBalancedKelvin) / std::expm1(exponent / kelvin);
  }
  return gain / gain[1];
}

} // namespace dewpoint::simulation
