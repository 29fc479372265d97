// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace dewpoint::experiment {

/// Checksum of rounded results (64-bit FNV-1a hash, folded to 32 bits). Two programs whose results
/// differ only by rounding errors have the same checksum.
class Fingerprint {
public:
  /// Adds a number, rounded to the nearest multiple of `step` (> 0). A value that is not finite is
  /// added as infinity or NaN.
  void add(double value, double step);
  /// Adds a number rounded to this many significant digits (1 to 15).
  void addDigits(double value, int digits);
  void add(std::string_view text);
  /// Returns the checksum as eight hexadecimal digits.
  std::string text() const;

private:
  std::uint64_t state_ = 14695981039346656037ULL; ///< offset basis of FNV-1a
};

} // namespace dewpoint::experiment
