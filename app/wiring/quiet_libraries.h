// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::app {

/// Silences warnings of FFmpeg, GStreamer and OpenCV about an input, which would appear beside the
/// error message of Dewpoint. Variables of these libraries that are set take precedence. Call it
/// first in main.
void quietLibraries();

} // namespace dewpoint::app
