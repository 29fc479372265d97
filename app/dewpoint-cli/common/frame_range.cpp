// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/common/frame_range.h"

#include <charconv>
#include <string_view>

namespace dewpoint::app {
namespace {

bool number(std::string_view part, std::int64_t& value) {
  const auto [end, problem] = std::from_chars(part.data(), part.data() + part.size(), value);
  return problem == std::errc() && end == part.data() + part.size() && value >= 0;
}

} // namespace

Result<FrameRange> parseFrames(const std::string& text) {
  const auto wrong = [&] {
    return failure(ErrorCode::BadValue, "", "--frames", "expected A:B, found " + text);
  };
  FrameRange range;
  if (text.empty()) {
    return range;
  }
  const auto colon = text.find(':');
  if (colon == std::string::npos) {
    return wrong();
  }
  const std::string_view first = std::string_view(text).substr(0, colon);
  const std::string_view last = std::string_view(text).substr(colon + 1);
  if (!first.empty() && !number(first, range.first)) {
    return wrong();
  }
  if (!last.empty()) {
    std::int64_t end = 0;
    if (!number(last, end) || end <= range.first) {
      return wrong();
    }
    range.end = end;
  }
  return range;
}

} // namespace dewpoint::app
