// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

namespace dewpoint::trajectory {

/// One line of a CSV table that is made to be pasted, ended when it goes. Numbers have a point in
/// any language and nine digits, of which no view shows more than seven; what is not a number is an
/// empty cell.
class CsvLine {
public:
  explicit CsvLine(std::string& text) : text_(text) {}
  ~CsvLine() { text_ += '\n'; }
  CsvLine(const CsvLine&) = delete;
  CsvLine& operator=(const CsvLine&) = delete;

  template <std::integral Number> CsvLine& put(Number number) {
    return putPlain(std::to_string(number));
  }
  CsvLine& put(double number);
  /// Of single precision: its own digits.
  CsvLine& put(float number);
  /// Quoted where RFC 4180 needs it.
  CsvLine& put(std::string_view word);

private:
  CsvLine& putPlain(std::string_view cell);

  std::string& text_;
  bool first_ = true;
};

} // namespace dewpoint::trajectory
