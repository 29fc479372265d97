// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <array>
#include <optional>

namespace dewpoint::trajectory {

/// Position at a time in seconds.
struct TimedPosition {
  double time = 0.0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// Returns the position at `time` between `begin` and `end`, which have different times. The curve
/// is a cubic Hermite polynomial. Its slope at `begin` is that of the parabola through `before`,
/// `begin` and `end`; its slope at `end` is that of the parabola through `begin`, `end` and
/// `after`. If `before` or `after` is missing, both slopes are those of the remaining parabola. If
/// both are missing, the curve is a straight line.
Eigen::Vector3d interpolatedPosition(const std::optional<TimedPosition>& before,
                                     const TimedPosition& begin, const TimedPosition& end,
                                     const std::optional<TimedPosition>& after, double time);

} // namespace dewpoint::trajectory
