// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/angle.h"
#include "core/base/floors.h"

namespace dewpoint::base {

// Numbers in the units that people read. Everywhere else a length is in meters, a time in seconds,
// an angle in radians and a share a part of 1.

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

} // namespace dewpoint::base
