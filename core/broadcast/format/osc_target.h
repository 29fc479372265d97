// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/message/frame_message.h"

#include <string>
#include <vector>

namespace dewpoint::broadcast {

/// Returns a frame as OSC bundles of up to kMaxDatagram bytes. Each begins with
/// - `/dewpoint/frame` i frame, i sequence, f time in seconds, i number of targets.
///
/// For a target with a position follow
/// - `/dewpoint/target` i id, s name, s state, f x, y, z, f velocity x, y, z (0 if unknown),
///   f existence probability;
/// - `/dewpoint/covariance` i id, f xx, xy, xz, yy, yz, zz;
/// - `/dewpoint/cameras` i id, s name of each camera that sees it;
///
/// and for a target without one
/// - `/dewpoint/absent` i id, s name, s state, f existence probability.
std::vector<std::string> oscFrameBundles(const FrameMessage& frame);

} // namespace dewpoint::broadcast
