// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace dewpoint::broadcast {

/// Forms in which results leave the program.
enum class OutletKind {
  JsonLines,   ///< lines of JSON over TCP
  WebPage,     ///< page for browsers and WebSocket
  OscMessages, ///< OSC datagrams
  TuioCursors, ///< TUIO datagrams
  CsvLines,    ///< lines of CSV in a file, in a named pipe or on standard output
};

/// How an output is doing.
struct OutletReport {
  OutletKind kind = OutletKind::JsonLines;
  /// Own address ("127.0.0.1:9001", "http://127.0.0.1:9002/"), address of the receiver, or file;
  /// "-" is standard output.
  std::string address;
  int clients = 0;          ///< programs that are connected
  std::int64_t sent = 0;    ///< lines or datagrams handed to the operating system
  std::int64_t dropped = 0; ///< lines or datagrams that a receiver was too slow for
  bool lacksReader = false; ///< true while no program reads the named pipe; nothing is sent then
  /// Message of the operating system if nothing can be written; empty if there is no such problem.
  std::string problem = {};
};

/// Returns in English where the results go: "JSON lines at 127.0.0.1:9001".
std::string placeText(const OutletReport& report);

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
