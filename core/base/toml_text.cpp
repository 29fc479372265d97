// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/toml_text.h"

#include "core/base/limits.h"
#include "core/base/one_line.h"
#include "core/base/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace dewpoint::base {
namespace {

/// The place behind a text in quotation marks, or behind a comment, that begins at `at`.
std::size_t behindQuoted(std::string_view text, std::size_t at) {
  if (text[at] == '#') {
    return std::min(text.find('\n', at), text.size());
  }
  const std::string_view three = text.substr(at, 3);
  const bool isLong = three == R"(""")" || three == "'''";
  const std::string_view quote = isLong ? three : text.substr(at, 1);
  for (at += quote.size(); at < text.size() && !text.substr(at).starts_with(quote); ++at) {
    if (!isLong && text[at] == '\n') {
      return at; // it is not closed
    }
    at += text[at] == '\\' && quote[0] == '"' ? 1 : 0;
  }
  return std::min(at + quote.size(), text.size());
}

/// How deep the place is in keys, arrays and inline tables: what toml++ 3.3 goes down by recursion.
class Nesting {
public:
  void pass(char letter) {
    switch (letter) {
    case '.':
      ++parts_;
      break;
    case '\n':
    case ',':
      parts_ = 0;
      break;
    case '[':
    case '{':
      around_.push_back(parts_ + 1);
      held_ += std::exchange(parts_, 0) + 1;
      break;
    case ']':
    case '}':
      if (!around_.empty()) {
        held_ -= around_.back();
        parts_ = around_.back() - 1;
        around_.pop_back();
      }
      break;
    default:
      break;
    }
  }
  std::size_t depth() const { return held_ + parts_; }

private:
  std::vector<std::size_t> around_; ///< levels that each open bracket adds
  std::size_t held_ = 0;            ///< their sum
  std::size_t parts_ = 0;           ///< dots of the key, or of the number, at this place
};

/// The line of the first place that is nested too deep; 0: none.
std::size_t lineTooDeep(std::string_view text) {
  std::size_t line = 1;
  Nesting nesting;
  for (std::size_t at = 0; at < text.size();) {
    const char letter = text[at];
    if (letter == '"' || letter == '\'' || letter == '#') {
      const std::size_t next = behindQuoted(text, at);
      line += static_cast<std::size_t>(std::ranges::count(text.substr(at, next - at), '\n'));
      at = next;
      continue;
    }
    nesting.pass(letter);
    if (nesting.depth() > limits::kMaxNesting) {
      return line;
    }
    line += letter == '\n' ? 1 : 0;
    ++at;
  }
  return 0;
}

} // namespace

Result<toml::table> parseToml(const std::string& text, const std::string& file) {
  if (const std::size_t line = lineTooDeep(text); line > 0) {
    return failure(
        ErrorCode::NotParsed, file, fmt::format("line {}", line),
        fmt::format("more than {} levels of keys, arrays and tables", limits::kMaxNesting));
  }
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

std::string tomlQuoted(const std::string& text) {
  std::string result = "\"";
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t bytes = utf8CharacterSize(rest);
    const char letter = rest.front();
    if (bytes == 0) {
      result += '?'; // the name of a file, say; TOML is UTF-8
    } else if (letter == '"' || letter == '\\') {
      result += '\\';
      result += letter;
    } else if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7F) {
      result += fmt::format("\\u{:04X}", static_cast<int>(letter));
    } else {
      result += rest.substr(0, bytes);
    }
    rest.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return result + "\"";
}

} // namespace dewpoint::base
