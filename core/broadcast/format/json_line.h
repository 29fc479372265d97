// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/message/frame_message.h"

#include <string>
#include <vector>

namespace dewpoint::broadcast {

/// Returns the rig as one line of JSON: `{"type":"rig",...}` with axes, unit, volume and cameras.
std::string jsonRigLine(const RigMessage& rig);
/// Returns a frame as one line of JSON: `{"type":"frame",...}`. The vector has exactly one element,
/// because a frame is one line (see StreamFormat::encode). Unknown values are null. Positions have
/// nine significant digits, covariances six. A covariance is written as xx, xy, xz, yy, yz, zz.
std::vector<std::string> jsonFrameLines(const FrameMessage& frame);

} // namespace dewpoint::broadcast
