// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::app {

/// Silences the warnings of FFmpeg, GStreamer and OpenCV about an input: they would stand beside
/// our one sentence. The variables of these libraries, where set, still decide. Call it first in
/// main.
void quietLibraries();

} // namespace dewpoint::app
