// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/common/frame_range.h"

#include "core/base/text_number.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace dewpoint::app {
namespace {

std::optional<std::int64_t> frameIn(std::string_view part) {
  const auto number = toNumber<std::int64_t>(part);
  return number && *number >= 0 ? number : std::nullopt;
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
  if (!first.empty()) {
    const auto begin = frameIn(first);
    if (!begin) {
      return wrong();
    }
    range.first = *begin;
  }
  if (!last.empty()) {
    const auto end = frameIn(last);
    if (!end || *end <= range.first) {
      return wrong();
    }
    range.end = *end;
  }
  return range;
}

} // namespace dewpoint::app
