// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/test_patterns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace dewpoint::capture {
namespace {

/// The patterns of videotestsrc, GStreamer 1.22.
constexpr std::array<std::string_view, 26> kTestPatterns{"smpte",
                                                         "snow",
                                                         "black",
                                                         "white",
                                                         "red",
                                                         "green",
                                                         "blue",
                                                         "checkers-1",
                                                         "checkers-2",
                                                         "checkers-4",
                                                         "checkers-8",
                                                         "circular",
                                                         "blink",
                                                         "smpte75",
                                                         "zone-plate",
                                                         "gamut",
                                                         "chroma-zone-plate",
                                                         "solid-color",
                                                         "ball",
                                                         "smpte100",
                                                         "bar",
                                                         "pinwheel",
                                                         "spokes",
                                                         "gradient",
                                                         "colors",
                                                         "smpte-rp-219"};

} // namespace

bool isTestPattern(std::string_view name) {
  return std::ranges::find(kTestPatterns, name) != kTestPatterns.end();
}

std::string testPatternList() {
  return fmt::format("{}", fmt::join(kTestPatterns, ", "));
}

} // namespace dewpoint::capture
