// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace dewpoint::broadcast {

/// Longest datagram that OSC bundles are divided into, in bytes: it fits into one packet of any
/// network, and a lost packet loses only the targets in it.
inline constexpr std::size_t kMaxDatagram = 1400;

/// An OSC message (opensoundcontrol.org, version 1.0): its address, and its arguments, which are
/// 32-bit integers (i), 32-bit floating-point numbers (f) and strings (s).
struct OscMessage {
  using Argument = std::variant<std::int32_t, float, std::string>;
  std::string_view address;
  std::vector<Argument> arguments;

  /// Appends three numbers.
  template <class Vector> void addVector(const Vector& vector) {
    for (int axis = 0; axis < 3; ++axis) {
      arguments.emplace_back(static_cast<float>(vector[axis]));
    }
  }
};

/// Bundle of OSC messages, to be executed at once by the receiver.
class OscBundle {
public:
  OscBundle();
  /// Appends messages in this order. Strings longer than 255 bytes are cut off.
  void add(const std::vector<OscMessage>& messages);
  /// Returns the bytes of the bundle.
  std::string bytes() const;
  std::size_t size() const;
  /// Returns the bytes that these messages add to a bundle.
  static std::size_t sizeOf(const std::vector<OscMessage>& messages);

private:
  struct Deleter {
    void operator()(void* bundle) const;
  };
  std::unique_ptr<void, Deleter> bundle_;
};

} // namespace dewpoint::broadcast
