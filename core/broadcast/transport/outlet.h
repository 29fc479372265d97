// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace dewpoint::broadcast {

/// Kinds of outputs through which results are sent to other programs.
enum class OutletKind {
  JsonLines,   ///< lines of JSON over TCP
  WebPage,     ///< page for browsers, and JSON lines over WebSocket
  OscMessages, ///< OSC datagrams
  TuioCursors, ///< TUIO datagrams
  CsvLines,    ///< lines of CSV in a file, in a named pipe or on standard output
};

/// Status of an output.
struct OutletReport {
  OutletKind kind = OutletKind::JsonLines;
  /// For a server, its own address ("127.0.0.1:9001", "http://127.0.0.1:9002/"). For datagrams, the
  /// address of the receiver. For CSV lines, the file; "-" is standard output.
  std::string address;
  int clientCount = 0;             ///< number of connected programs
  std::int64_t sentPieceCount = 0; ///< number of lines or datagrams passed to the operating system
  /// Number of lines or datagrams that were not sent because a receiver was too slow.
  std::int64_t droppedPieceCount = 0;
  /// True while no program reads from the named pipe, so that nothing is sent.
  bool hasNoReader = false;
  /// Message of the operating system if nothing can be written; empty if there is no such problem.
  std::string problem = {};
};

/// Returns the kind and address of an output in English, for example "JSON lines at
/// 127.0.0.1:9001".
std::string outletAddressText(const OutletReport& report);

/// Immutable bytes that several threads and clients share.
using SharedBytes = std::shared_ptr<const std::string>;

/// Output that sends results to other programs. No call waits for a receiver. If a receiver is too
/// slow, the oldest data is dropped and counted.
class Outlet {
public:
  virtual ~Outlet() = default;
  /// Sends the pieces of one frame (StreamFormat::encode).
  virtual void send(const std::vector<std::string>& pieces) = 0;
  /// Returns the status of the output.
  virtual OutletReport report() const = 0;
};

/// Output that knows when a receiver begins to read, and can therefore send it a preamble (text
/// before the first frame). An output of datagrams does not know this.
class PreambleOutlet : public Outlet {
public:
  /// Sets the preamble: text that each new receiver gets first. If the preamble changes, connected
  /// receivers also get the new one.
  virtual void setPreamble(const std::string& preamble) = 0;
};

} // namespace dewpoint::broadcast
