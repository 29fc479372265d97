// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace dewpoint::trajectory {

/// Appends a number as little-endian bytes.
template <class T> void putLittleEndian(std::string& bytes, T value) {
  static_assert(std::is_arithmetic_v<T>);
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) {
    for (std::size_t k = sizeof(T); k-- > 0;) {
      bytes.push_back(raw[k]);
    }
  } else {
    bytes.append(raw, sizeof(T));
  }
}

} // namespace dewpoint::trajectory
