// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/reference/markdown.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace dewpoint::app {
namespace {

std::string tableRow(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

} // namespace

std::string markdownText(std::string_view text) {
  std::string escaped;
  for (const char sign : text) {
    switch (sign) {
    case '<':
      escaped += "&lt;";
      break;
    case '\n':
      escaped += ' ';
      break;
    case '|':
    case '*':
    case '_':
    case '[':
    case ']':
    case '`':
      escaped += '\\';
      [[fallthrough]];
    default:
      escaped += sign;
    }
  }
  return escaped;
}

std::string markdownCode(std::string_view text) {
  return text.empty() ? std::string() : fmt::format("`{}`", text);
}

std::string markdownTable(const std::vector<std::string>& head,
                          const std::vector<std::vector<std::string>>& rows) {
  std::string text = tableRow(head) + tableRow(std::vector<std::string>(head.size(), "---"));
  for (const auto& row : rows) {
    text += tableRow(row);
  }
  return text;
}

} // namespace dewpoint::app
