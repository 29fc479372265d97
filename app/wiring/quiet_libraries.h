// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::app {

/// Silences warnings from FFmpeg, GStreamer and OpenCV about an input, because Dewpoint prints its
/// own error message. Environment variables of these libraries take precedence if they are set.
/// Call this function first in main.
void silenceLibraries();

} // namespace dewpoint::app
