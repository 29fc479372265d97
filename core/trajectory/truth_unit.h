// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"

#include <optional>

namespace dewpoint::trajectory {

/// Converts a trajectory to meters. `unit` is the length unit of the trajectory in meters, for
/// example 0.001 for millimeters. Positions are multiplied by `unit`, and covariances and extents
/// by its square.
Trajectory toMeters(Trajectory trajectory, double unit);

/// Returns the length unit of the truth, in meters, if the truth is probably given in millimeters
/// or centimeters. This is the case if the center and spread of the true positions agree with those
/// of the estimate after conversion from this unit. Returns nothing if they already agree without
/// conversion, or if they agree in neither unit.
std::optional<double> likelyTruthUnit(const Trajectory& estimate, const Trajectory& truth);

} // namespace dewpoint::trajectory
