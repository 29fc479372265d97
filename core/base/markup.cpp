// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/markup.h"

namespace dewpoint::base {

std::string htmlEscaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += letter;
    }
  }
  return result;
}

} // namespace dewpoint::base
