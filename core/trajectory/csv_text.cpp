// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/csv_text.h"

namespace dewpoint::trajectory {

std::string withoutLineBreaks(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20)
      c = ' ';
  return line;
}

std::string quotedCsv(std::string_view text) {
  std::string result = "\"";
  for (char c : withoutLineBreaks(text))
    result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

std::string csvCell(std::string_view text) {
  const bool plain = text.find_first_of(",\"#") == std::string_view::npos &&
                     (text.empty() || (text.front() != ' ' && text.back() != ' '));
  return plain ? withoutLineBreaks(text) : quotedCsv(text);
}

} // namespace dewpoint::trajectory
