// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::tracking {

/// Seconds; a longer gap between two frames is a new scene as far as motion is concerned.
inline constexpr double kLongestGap = 1.0;
/// Seconds, gap before a frame whose time tells none, as of one that is earlier than the last: the
/// user went back.
inline constexpr double kDefaultGap = 1.0 / 30.0;

} // namespace dewpoint::tracking
