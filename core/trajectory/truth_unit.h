// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"

#include <optional>

namespace dewpoint::trajectory {

/// Converts a trajectory to meters. `unitInMeters` is the length unit of the trajectory, for
/// example 0.001 for millimeters. Positions are multiplied by `unitInMeters`, and covariances and
/// extents by its square.
Trajectory toMeters(Trajectory trajectory, double unitInMeters);

/// Returns the length unit of the truth, in meters, if the truth is probably given in millimeters
/// or centimeters. This is the case if the center and spread of the true positions agree with those
/// of the estimate after conversion from this unit. Returns nothing if they already agree without
/// conversion, or if they agree in neither unit.
std::optional<double> likelyTruthUnitInMeters(const Trajectory& estimate, const Trajectory& truth);

} // namespace dewpoint::trajectory
