// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/transport/file_descriptor.h"
#include "core/broadcast/transport/outgoing_queue.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::broadcast {

/// Connection of a LineServer to one program.
class LineClient {
public:
  explicit LineClient(FileDescriptor socket) : socket_(std::move(socket)) {}

  int socket() const { return socket_.number(); }
  bool isOpen() const { return socket_.isOpen(); }
  /// Returns whether the client may still send commands. This is false after the client has closed
  /// its sending side.
  bool maySendCommands() const { return maySendCommands_; }
  bool hasWaitingBytes() const { return !queue_.empty(); }

  /// Appends a piece (a line or message) to the queue of those to send. Returns the number of
  /// pieces that were dropped because the queue is full.
  std::int64_t push(SharedBytes bytes) { return queue_.push(std::move(bytes)); }
  /// Sends as many of the waiting bytes as the network accepts immediately. Returns the number of
  /// pieces (lines or messages) that were sent completely. Closes the socket after an error.
  std::int64_t sendWaiting();
  /// Reads at most 16 KiB of the data that has arrived. Returns the lines that are now complete,
  /// without their line ends. Lines longer than kMaxRemoteCommandBytes are omitted. A client that
  /// has closed only its sending side still receives data.
  std::vector<std::string> receive();

private:
  void addInput(const char* bytes, std::size_t count, std::vector<std::string>& lines);

  FileDescriptor socket_;
  OutgoingQueue queue_;
  std::size_t sent_ = 0; ///< number of bytes of the first piece that were sent
  std::string input_;    ///< the beginning of a line
  bool isTooLong_ = false;
  bool maySendCommands_ = true;
};

} // namespace dewpoint::broadcast
