// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/message/frame_message.h"

#include <string>
#include <vector>

namespace dewpoint::broadcast {

/// Returns the line of column names, which contain the unit.
std::string csvHeaderRow(const RigMessage& rig);
/// Returns one row per target. Unknown values are empty. The names of the cameras that see a target
/// are in one cell, separated by semicolons.
std::vector<std::string> csvFrameRows(const FrameMessage& frame);

} // namespace dewpoint::broadcast
