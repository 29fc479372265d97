// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

namespace dewpoint::trajectory {

/// One line of a CSV table for the clipboard; the destructor ends the line. Floating-point numbers
/// have a decimal point in every locale, and nine significant digits, which is at least two more
/// than any view in the window shows. A value that is not a number becomes an empty cell.
class CsvLine {
public:
  explicit CsvLine(std::string& text) : text_(text) {}
  ~CsvLine() { text_ += '\n'; }
  CsvLine(const CsvLine&) = delete;
  CsvLine& operator=(const CsvLine&) = delete;

  template <std::integral Number> CsvLine& put(Number number) {
    return putPlain(std::to_string(number));
  }
  /// Appends a number with nine significant digits.
  CsvLine& put(double number);
  /// Appends a number with as many digits as single precision requires.
  CsvLine& put(float number);
  /// Appends a string, quoted where RFC 4180 requires it.
  CsvLine& put(std::string_view word);

private:
  CsvLine& putPlain(std::string_view cell);

  std::string& text_;
  bool first_ = true;
};

} // namespace dewpoint::trajectory
