// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstdint>
#include <optional>
#include <string>

namespace dewpoint::app {

/// Frames `first` to `end` - 1; to the last one where there is no `end`.
struct FrameRange {
  std::int64_t first = 0;
  std::optional<std::int64_t> end;
};

/// Reads "A:B", either of which may be empty; all frames where the text is empty. Errors name
/// --frames.
Result<FrameRange> parseFrames(const std::string& text);

} // namespace dewpoint::app
