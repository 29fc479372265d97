// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/toml_text.h"

#include "core/base/text_file.h"

#include <fmt/format.h>

#include <string_view>

namespace dewpoint::base {

Result<toml::table> parseToml(const std::string& text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    std::string_view reason = error.description();
    constexpr std::string_view kKnown = "Error while parsing "; // the phrase says it already
    if (reason.starts_with(kKnown)) {
      reason.remove_prefix(kKnown.size());
    }
    return failure(ErrorCode::NotParsed, file, fmt::format("line {}", error.source().begin.line),
                   std::string(reason));
  }
}

Result<toml::table> readTomlFile(const std::filesystem::path& file) {
  return readTextFile(file).and_then(
      [&](const std::string& text) { return parseToml(text, file.string()); });
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') {
      result += '\\';
      result += letter;
    } else if (static_cast<unsigned char>(letter) < 0x20) {
      result += fmt::format("\\u{:04X}", static_cast<int>(letter));
    } else {
      result += letter;
    }
  }
  return result + "\"";
}

} // namespace dewpoint::base
