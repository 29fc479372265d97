// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace dewpoint::experiment {

/// A checksum of what was computed, rounded: of two programs whose numbers differ by rounding
/// errors only it is the same, of two that compute something else it is not. (FNV-1a, 64 bits, by
/// G. Fowler, L. C. Noll and K.-P. Vo, folded to 32.)
class Fingerprint {
public:
  /// A number, rounded to the nearest multiple of `step` (> 0); what is not finite counts as such.
  void add(double value, double step);
  /// A number rounded to this many significant digits (1 to 15).
  void addDigits(double value, int digits);
  void add(std::string_view text);
  /// Eight hexadecimal digits.
  std::string text() const;

private:
  std::uint64_t state_ = 14695981039346656037ULL; ///< offset basis of FNV-1a
};

} // namespace dewpoint::experiment
