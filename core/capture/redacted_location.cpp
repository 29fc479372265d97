// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/redacted_location.h"

#include "core/base/lower_case.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

namespace dewpoint::capture {
namespace {

constexpr std::string_view kStars = "***";

/// Whether the value of an option of this name is a secret.
bool isSecret(std::string_view option) {
  static constexpr std::array<std::string_view, 9> kParts{
      "pass", "pwd", "-pw", "token", "secret", "apikey", "api_key", "signature", "auth"};
  static constexpr std::array<std::string_view, 3> kNames{"pw", "key", "sig"};
  const std::string name = toLowerCase(option);
  return std::ranges::find(kNames, name) != kNames.end() ||
         std::ranges::any_of(
             kParts, [&](std::string_view part) { return name.find(part) != std::string::npos; });
}

/// "user:password" becomes "user:***", what has no colon is a secret as a whole.
void hideUser(std::string& text) {
  for (std::size_t at = text.find("://"); at != std::string::npos; at = text.find("://", at)) {
    at += 3;
    const std::size_t end = std::min(text.find_first_of("/?# \"'", at), text.size());
    // A password may hold further such signs: the host begins after the last one.
    const std::size_t host = text.substr(at, end - at).rfind('@');
    if (host != std::string::npos) {
      const std::size_t colon = text.substr(at, host).find(':');
      const std::size_t from = colon == std::string::npos ? at : at + colon + 1;
      text.replace(from, at + host - from, kStars);
    }
  }
}

void hideOptions(std::string& text) {
  for (std::size_t at = text.find('='); at != std::string::npos; at = text.find('=', at + 1)) {
    std::size_t begin = at;
    const auto belongs = [&](std::size_t place) {
      const auto letter = static_cast<unsigned char>(text[place]);
      return std::isalnum(letter) != 0 || letter == '-' || letter == '_';
    };
    while (begin > 0 && belongs(begin - 1)) {
      --begin;
    }
    if (!isSecret(std::string_view(text).substr(begin, at - begin))) {
      continue;
    }
    const bool isQuoted = at + 1 < text.size() && (text[at + 1] == '"' || text[at + 1] == '\'');
    const std::size_t from = at + 1 + (isQuoted ? 1 : 0);
    const std::size_t end =
        isQuoted ? text.find(text[at + 1], from) : text.find_first_of("&;! \t\"'#", from);
    text.replace(from, std::min(end, text.size()) - from, kStars);
  }
}

} // namespace

std::string redactedLocation(std::string_view location) {
  std::string shown(location);
  if (shown.starts_with("gst:") || shown.find("://") != std::string::npos) {
    hideUser(shown);
    hideOptions(shown);
  }
  return shown;
}

} // namespace dewpoint::capture
