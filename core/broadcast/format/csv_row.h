// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/message/frame_message.h"

#include <string>
#include <vector>

namespace dewpoint::broadcast {

/// Returns the first line of the CSV output: the names of the columns, which include the unit of
/// lengths.
std::string csvHeaderRow(const RigMessage& rig);
/// Returns the CSV rows of a frame, one per target. Cells of unknown values are empty. One cell
/// contains the names of all cameras that see the target, separated by semicolons.
std::vector<std::string> csvFrameRows(const FrameMessage& frame);

} // namespace dewpoint::broadcast
