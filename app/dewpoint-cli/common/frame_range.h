// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/session/run/frame_loop.h"

#include <string>

namespace dewpoint::app {

/// Parses the range of frames "A:B", where A or B may be empty; an empty string means all frames.
/// Returns an error that names the option --frames if the text is invalid.
Result<FrameRange> parseFrames(const std::string& text);

} // namespace dewpoint::app
