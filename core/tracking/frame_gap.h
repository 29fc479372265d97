// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::tracking {

/// Longest time between two frames that motion models use, in seconds. For longer gaps they use
/// this value, since motion before such a gap tells nothing about the scene after it.
inline constexpr double kLongestGap = 1.0;
/// Assumed time since the previous frame, in seconds, if it cannot be computed from the frame
/// times. This is the case if a frame is earlier than the previous one because the user went back.
inline constexpr double kDefaultGap = 1.0 / 30.0;

} // namespace dewpoint::tracking
