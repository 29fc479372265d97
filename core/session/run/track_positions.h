// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/tracking/parameters.h"
#include "core/trajectory/trajectory.h"

#include <cstdint>
#include <string_view>

namespace dewpoint::session {

/// Frames per second of measured positions, unless given.
inline constexpr double kPositionsPerSecond = 30.0;

/// Where the file had only frames, gives each sample the time of its frame at `rate` frames per
/// second; where it had only times, numbers the instants as frames. True when times were given.
/// MissingKey where a sample has neither, or some have times and others not.
Result<bool> giveTimes(Trajectory& measured, double rate);

/// Whether trackPositions() takes this parameter from the first position of each target: start_x,
/// start_y, start_z.
bool isStartOfPositions(std::string_view key);

/// Method dynamics over measured 3D positions instead of images (Barrera et al. 2005, section
/// III-C): every target of `measured` is tracked by a filter of its own, which does the method's
/// iterations on each sample and starts at the target's first position. A sample whose position is
/// not a number, or that is not valid, is taken as not measured. BadValue when that first position
/// is farther away than the method's parameters allow.
Result<Trajectory> trackPositions(const Trajectory& measured, const ParameterValues& parameters,
                                  std::uint64_t seed);

} // namespace dewpoint::session
