// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/csv_line.h"

#include <array>
#include <charconv>
#include <cmath>

namespace dewpoint::trajectory {
namespace {

constexpr int kDigits = 9;

template <std::floating_point Number> std::string digitsOf(Number number) {
  if (!std::isfinite(number)) {
    return {};
  }
  std::array<char, 32> digits{};
  char* const begin = digits.data();
  const auto done =
      std::to_chars(begin, begin + digits.size(), number, std::chars_format::general, kDigits);
  return {begin, done.ptr};
}

} // namespace

CsvLine& CsvLine::put(double number) {
  return putPlain(digitsOf(number));
}

CsvLine& CsvLine::put(float number) {
  return putPlain(digitsOf(number));
}

CsvLine& CsvLine::put(std::string_view word) {
  if (word.find_first_of(",\"\n") == std::string_view::npos) {
    return putPlain(word);
  }
  std::string quoted = "\"";
  for (const char letter : word) {
    quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  }
  return putPlain(quoted + '"');
}

CsvLine& CsvLine::putPlain(std::string_view cell) {
  if (!first_) {
    text_ += ',';
  }
  first_ = false;
  text_ += cell;
  return *this;
}

} // namespace dewpoint::trajectory
