// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QByteArray>

#include <array>
#include <charconv>
#include <cmath>
#include <type_traits>

namespace dewpoint::ui {

/// One line of a CSV table, ended when it goes. Numbers have a point in any language; what is not
/// a number is an empty cell.
class CsvLine {
public:
  explicit CsvLine(QByteArray& text) : text_(text) {}
  ~CsvLine() { text_.append('\n'); }
  CsvLine(const CsvLine&) = delete;
  CsvLine& operator=(const CsvLine&) = delete;

  template <class Number>
  requires std::is_arithmetic_v<Number> CsvLine& put(Number number) {
    begin();
    std::array<char, 32> digits{};
    char* end = digits.data();
    char* const most = digits.data() + digits.size();
    if constexpr (std::is_floating_point_v<Number>) {
      constexpr int kDigits = 9; // of which no view shows more than 7
      if (std::isfinite(number)) {
        end = std::to_chars(end, most, number, std::chars_format::general, kDigits).ptr;
      }
    } else {
      end = std::to_chars(end, most, number).ptr;
    }
    text_.append(digits.data(), end - digits.data());
    return *this;
  }
  /// Quoted where RFC 4180 needs it.
  CsvLine& put(QByteArray word) {
    begin();
    if (word.contains(',') || word.contains('"') || word.contains('\n')) {
      word = '"' + word.replace('"', "\"\"") + '"';
    }
    text_.append(word);
    return *this;
  }

private:
  void begin() {
    if (!first_) {
      text_.append(',');
    }
    first_ = false;
  }

  QByteArray& text_;
  bool first_ = true;
};

} // namespace dewpoint::ui
