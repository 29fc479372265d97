// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"

#include <optional>

namespace dewpoint::trajectory {

/// Converts a trajectory to meters. `unit` is the length unit of its numbers in meters, for example
/// 0.001 for millimeters. Positions are multiplied by `unit`, and covariances and extents by its
/// square.
Trajectory inMeters(Trajectory trajectory, double unit);

/// Returns the length unit (in meters) of the truth if it is probably a millimeter or a centimeter.
/// In this unit, the center and spread of the true positions agree with those of the estimate.
/// Returns nothing if the truth agrees with the estimate in meters, or in none of these units.
std::optional<double> likelyTruthUnit(const Trajectory& estimate, const Trajectory& truth);

} // namespace dewpoint::trajectory
