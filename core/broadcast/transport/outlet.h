// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace dewpoint::broadcast {

/// How an output is doing.
struct OutletReport {
  std::string place;        ///< where the results go, for the user: "JSON lines at 127.0.0.1:9001"
  int clients = 0;          ///< programs that are connected
  std::int64_t sent = 0;    ///< lines or datagrams handed to the operating system
  std::int64_t dropped = 0; ///< lines or datagrams that a receiver was too slow for
  std::string problem = {}; ///< why nothing is sent at present; empty: nothing is wrong
};

/// Bytes that several threads and clients share.
using SharedBytes = std::shared_ptr<const std::string>;

/// Way out of the program. No call ever waits for a receiver: what it cannot take at once is
/// dropped, the oldest first, and counted.
class Outlet {
public:
  virtual ~Outlet() = default;
  /// Sets what each receiver gets first. If it changes, present receivers get it too.
  virtual void setOpening(const std::string& opening) = 0;
  /// Sends the pieces of one frame.
  virtual void send(const std::vector<std::string>& pieces) = 0;
  virtual OutletReport report() const = 0;
};

} // namespace dewpoint::broadcast
