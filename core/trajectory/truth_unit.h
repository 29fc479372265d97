// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"

#include <optional>

namespace dewpoint::trajectory {

/// Returns the trajectory with its positions multiplied by `unit`: meters, if its numbers were in
/// units of `unit` meters. Covariances and extents are scaled with them.
Trajectory inMeters(Trajectory trajectory, double unit);

/// Returns the unit, in meters, that the truth is probably in: a millimeter or a centimeter. Its
/// center and spread then lie where those of the estimate are. Returns nothing if the truth fits as
/// it is, or fits in neither unit.
std::optional<double> likelyTruthUnit(const Trajectory& estimate, const Trajectory& truth);

} // namespace dewpoint::trajectory
