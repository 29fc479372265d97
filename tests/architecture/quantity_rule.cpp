// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/quantity_rule.h"

#include <regex>

namespace dewpoint::tests {
namespace {

/// Whether a file of core or the command line has a factor of its own for a reason: the functions
/// that all others call, and hues, whose degrees are rounded otherwise.
bool mayHaveFactors(const std::string& path) {
  return path == "core/base/units.h" || path == "core/color/hsi.h";
}

} // namespace

std::vector<std::string> quantitiesByHand(const std::string& path, std::string_view text) {
  const bool inWindow = path.starts_with("ui/") && !path.starts_with("ui/text/quantity_text.");
  const bool inCore = path.starts_with("core/") || path.starts_with("app/");
  if (!inWindow && (!inCore || mayHaveFactors(path))) {
    return {};
  }
  // A text may be divided over lines; what comments say is shown to nobody.
  static const std::regex kComment("//[^\n]*");
  static const std::regex kSeam("\"\\s*\"");
  const std::string code =
      std::regex_replace(std::regex_replace(std::string(text), kComment, ""), kSeam, "");
  static const std::regex kUnit("%[0-9]+(°| ?(px|mm|cm|m/s(?!²)|m|µs|ms|s)(?![A-Za-z0-9_/]))");
  static const std::regex kFactor("(number|tableNumber|significantDigits)Text\\([^,;]*"
                                  "\\b(1000\\.0|1e3|200\\.0|180\\.0|100\\.0|kDegree)\\b");
  static const std::regex kAnyFactor(
      "\\b(1000\\.0|1e3|180\\.0|100\\.0|1e2) \\*|"
      "\\* (1000\\.0|1e3|180\\.0|100\\.0|1e2)\\b|/ (base::)?kDegree\\b");
  static const std::regex kNamedFactor(
      "\\bk\\w*(Milli|Centi|Percent)\\w* = (1000\\.0|1e3|100\\.0|1e2)\\b");
  // A factor beside a formatter, or under a name of its own, is the same work.
  static const std::regex kThousand(
      "\\b(1000\\.0|1e3) \\*|[*/] (1000\\.0|1e3)\\b|\\bkMilli\\w+ = ");
  // People count frames from 1; the formatter of the number adds it.
  static const std::regex kFrame("(\\.arg|toString|QString::number|[nN]umberText)\\("
                                 "[^;{}\"]*?[fF]rame\\w*[()]* \\+ 1\\b");
  std::vector<std::string> found;
  for (const std::regex& rule : inWindow ? std::vector{kUnit, kFactor, kThousand, kFrame}
                                         : std::vector{kAnyFactor, kNamedFactor}) {
    for (std::sregex_iterator match(code.begin(), code.end(), rule), end; match != end; ++match) {
      found.push_back(match->str());
    }
  }
  return found;
}

} // namespace dewpoint::tests
