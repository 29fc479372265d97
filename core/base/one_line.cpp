// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/one_line.h"

#include <algorithm>
#include <cstddef>

namespace dewpoint::base {
namespace {

/// Longer texts come from files, and nobody reads them to their end.
constexpr std::size_t kMostMessageBytes = 4000;

} // namespace

std::size_t utf8CharacterSize(std::string_view text) {
  if (text.empty()) {
    return 0;
  }
  const auto byteAt = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
  const unsigned first = byteAt(0);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length > text.size()) {
    return 0;
  }
  for (std::size_t at = 1; at < length; ++at) {
    if ((byteAt(at) & 0xC0U) != 0x80U) {
      return 0;
    }
  }
  // Overlong forms, surrogates, and beyond the last character.
  const unsigned second = length > 2 ? byteAt(1) : 0x80U;
  const bool isForbidden = (first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) ||
                           (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90);
  return isForbidden ? 0 : length;
}

std::string toSingleLine(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const std::size_t length = utf8CharacterSize(text);
    if (line.size() + std::max<std::size_t>(length, 1) > kMostMessageBytes) {
      return line + "...";
    }
    const auto first = static_cast<unsigned char>(text.front());
    const bool isPlain = length > 0 && first >= 0x20 && first != 0x7F;
    line += isPlain ? text.substr(0, length) : std::string_view("?");
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return line;
}

} // namespace dewpoint::base
