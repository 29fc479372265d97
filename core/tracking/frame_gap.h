// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::tracking {

/// Longest time step in seconds that motion models use. A longer gap between two frames is treated
/// as this time, since motion before such a gap says nothing about the scene after it.
inline constexpr double kLongestGap = 1.0;
/// Assumed time since the previous frame, in seconds, if the frame times do not give it. This
/// happens when the user goes back, so that a frame is earlier than the previous frame.
inline constexpr double kDefaultGap = 1.0 / 30.0;

} // namespace dewpoint::tracking
