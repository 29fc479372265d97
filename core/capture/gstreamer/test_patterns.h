// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>
#include <string_view>

namespace dewpoint::capture {

/// Returns whether GStreamer's test source (videotestsrc) has a pattern of this name.
bool isTestPattern(std::string_view name);
/// Returns the names of all test patterns, separated by commas.
std::string testPatternList();

} // namespace dewpoint::capture
