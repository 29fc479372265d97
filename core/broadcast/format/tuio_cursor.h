// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/message/frame_message.h"

#include <string>
#include <vector>

namespace dewpoint::broadcast {

/// Returns a frame as bundles of TUIO 1.1 3D cursors (tuio.org, specification 1.1, profile 3Dcur):
/// - `/tuio/3Dcur` s "alive", i id of each target with a position;
/// - `/tuio/3Dcur` s "set", i id, f x, y, z, f velocity x, y, z, f acceleration along the path;
/// - `/tuio/3Dcur` s "fseq", i sequence.
///
/// Positions are fractions of RigMessage::volume along the axes of the output: 0 at the minimum and
/// 1 at the maximum of the volume. Positions outside the volume are below 0 or above 1. Velocities
/// are fractions per second. If the cursors do not fit into one datagram, they are distributed
/// among several bundles with the same `alive` list and the same `fseq`.
std::vector<std::string> tuioFrameBundles(const FrameMessage& frame);

} // namespace dewpoint::broadcast
