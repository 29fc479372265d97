// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/motion.h"

#include <span>
#include <string>

namespace dewpoint::trajectory {

/// A CSV table of a motion with its speed, to be pasted: a line per row, meters and seconds, frames
/// from 0, standard deviations instead of covariances. What an export writes is in
/// export_formats.h.
std::string motionCsv(std::span<const MotionLog::Row> rows);

} // namespace dewpoint::trajectory
