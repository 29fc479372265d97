// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/session/run/frame_loop.h"

#include <string>

namespace dewpoint::app {

/// Reads "A:B", either of which may be empty; all frames where the text is empty. Errors name
/// --frames.
Result<FrameRange> parseFrames(const std::string& text);

} // namespace dewpoint::app
