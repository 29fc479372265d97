// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/angle.h"
#include "core/base/floors.h"

namespace dewpoint::base {

// Conversions to the units shown to users. Everywhere else, lengths are in meters, times in
// seconds, angles in radians, and fractions between 0 and 1.

inline constexpr double inMillimeters(double meters) {
  return 1000.0 * meters;
}
inline constexpr double inCentimeters(double meters) {
  return 100.0 * meters;
}
inline constexpr double inMilliseconds(double seconds) {
  return 1000.0 * seconds;
}
inline constexpr double inDegrees(double radians) {
  return radians / kDegree;
}
inline constexpr double inPercent(double share) {
  return 100.0 * share;
}

// Conversions back to the internal units.
inline constexpr double fromMillimeters(double millimeters) {
  return millimeters / 1000.0;
}
inline constexpr double fromCentimeters(double centimeters) {
  return centimeters / 100.0;
}
inline constexpr double fromMilliseconds(double milliseconds) {
  return milliseconds / 1000.0;
}

} // namespace dewpoint::base
