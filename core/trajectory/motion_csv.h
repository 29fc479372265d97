// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/motion.h"

#include <span>
#include <string>

namespace dewpoint::trajectory {

/// Returns a CSV table of the positions and speeds in a MotionLog, for the clipboard: one line per
/// row, in meters and seconds. Frames are counted from 0. Standard deviations are written instead
/// of covariances. For the export formats, see export_formats.h.
std::string motionCsv(std::span<const MotionLog::Row> rows);

} // namespace dewpoint::trajectory
