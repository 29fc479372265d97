// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace dewpoint::tests {

/// An input of the fuzzers' corpus, "project/everything.toml".
inline std::string corpusText(const std::string& name) {
  const auto file = std::filesystem::path(DEWPOINT_SOURCE_DIR) / "tests" / "fuzz" / "corpus" / name;
  return base::readTextFile(file).value();
}

/// Writes a file without waiting for the disk, which writeTextFile() does.
inline void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

/// The text as an editor under Windows saves it.
inline std::string asOfWindows(const std::string& text) {
  std::string changed = "\xEF\xBB\xBF";
  for (const char letter : text) {
    changed += letter == '\n' ? "\r\n" : std::string(1, letter);
  }
  return changed;
}

struct NumberPlace {
  std::size_t begin = 0;
  std::size_t count = 0;
};

/// Every number that is a value of the text: behind '=' (or ':'), in no quotation marks and in no
/// comment.
inline std::vector<NumberPlace> numberPlaces(const std::string& text) {
  std::vector<NumberPlace> places;
  bool isValue = false;
  bool isQuoted = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char letter = text[at];
    isQuoted = letter == '\n' ? false : letter == '"' ? !isQuoted : isQuoted;
    if (letter == '\n') {
      isValue = false;
    } else if (!isQuoted && letter == '#') {
      at = text.find('\n', at) - 1;
    } else if (!isQuoted && (letter == '=' || letter == ':')) {
      isValue = true;
    } else if (isValue && !isQuoted && std::isdigit(static_cast<unsigned char>(letter)) != 0) {
      const std::size_t sign = text[at - 1] == '-' ? 1 : 0;
      const std::size_t end = std::min(text.find_first_not_of("0123456789.e-+", at), text.size());
      places.push_back({at - sign, end - at + sign});
      at = end - 1;
    }
  }
  return places;
}

} // namespace dewpoint::tests
