// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/tracking/parameters.h"
#include "core/trajectory/trajectory.h"

#include <cstdint>
#include <string_view>

namespace dewpoint::session {

/// Default frame rate of measured positions that have no times, in frames per second.
inline constexpr double kPositionsPerSecond = 30.0;

/// Adds missing times or frame numbers, and returns whether times were added. If no sample has a
/// time, computes the times from the frame numbers at `rate` frames per second. If all samples have
/// times, gives each sample without a frame number the rank of its time among all different times,
/// counted from 0. Returns MissingKey if only some samples have times, or if a sample has neither a
/// time nor a frame number.
Result<bool> addMissingTimes(Trajectory& measured, double rate);

/// Returns whether trackPositions() sets this parameter to a coordinate of each target's first
/// position: true for start_x, start_y and start_z.
bool isStartPositionParameter(std::string_view key);

/// Runs the `dynamics` method on measured 3D positions instead of images (Barrera et al. 2005,
/// section III-C), and returns the filtered trajectory. Every target of `measured` has its own
/// filter, which starts at the target's first position and runs the method's iterations on each
/// sample. A sample that is not valid or whose position is NaN counts as not measured. Returns
/// BadValue if a coordinate of a first position is outside the range of start_x, start_y or
/// start_z.
Result<Trajectory> trackPositions(const Trajectory& measured, const ParameterValues& parameters,
                                  std::uint64_t seed);

} // namespace dewpoint::session
