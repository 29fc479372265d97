// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/message/frame_message.h"

#include <string>
#include <vector>

namespace dewpoint::broadcast {

/// Returns a frame as OSC bundles of at most kMaxDatagram bytes. Each bundle begins with
/// - `/dewpoint/frame` i frame, i sequence, f time in seconds, i number of targets.
///
/// It continues, for each target with a position, with
/// - `/dewpoint/target` i id, s name, s state, f x, y, z, f velocity x, y, z (0 if unknown), f
///   existence probability;
/// - `/dewpoint/covariance` i id, f xx, xy, xz, yy, yz, zz;
/// - `/dewpoint/cameras` i id, s name of each camera that sees the target;
///
/// and for each target without a position, with
/// - `/dewpoint/absent` i id, s name, s state, f existence probability.
std::vector<std::string> oscFrameBundles(const FrameMessage& frame);

} // namespace dewpoint::broadcast
