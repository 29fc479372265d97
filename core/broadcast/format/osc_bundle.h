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

/// Maximum size of a datagram with an OSC bundle, in bytes. A datagram of this size fits into one
/// network packet. If a packet is lost, only the targets in this packet are lost.
inline constexpr std::size_t kMaxDatagram = 1400;

/// An OSC message (opensoundcontrol.org, version 1.0): an address and arguments. An argument is a
/// 32-bit integer (i), a 32-bit floating-point number (f) or a string (s).
struct OscMessage {
  using Argument = std::variant<std::int32_t, float, std::string>;
  std::string_view address;
  std::vector<Argument> arguments;

  /// Appends the three components of a vector as arguments.
  template <class Vector> void addVector(const Vector& vector) {
    for (int axis = 0; axis < 3; ++axis) {
      arguments.emplace_back(static_cast<float>(vector[axis]));
    }
  }
};

/// Bundle of OSC messages that the receiver executes together.
class OscBundle {
public:
  OscBundle();
  /// Appends messages to the bundle. Strings longer than 255 bytes are cut off.
  void add(const std::vector<OscMessage>& messages);
  /// Returns the encoded bundle.
  std::string bytes() const;
  /// Returns the size of the encoded bundle, bytes.
  std::size_t byteCount() const;
  /// Returns the number of bytes that these messages add to a bundle.
  static std::size_t byteCountOf(const std::vector<OscMessage>& messages);

private:
  struct Deleter {
    void operator()(void* bundle) const;
  };
  std::unique_ptr<void, Deleter> bundle_;
};

} // namespace dewpoint::broadcast
