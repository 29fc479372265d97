// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/lower_case.h"

namespace dewpoint::base {

std::string toLowerCase(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower) {
    // Not std::tolower(), which asks the locale.
    const bool isCapital = letter >= 'A' && letter <= 'Z';
    letter = isCapital ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  return lower;
}

} // namespace dewpoint::base
