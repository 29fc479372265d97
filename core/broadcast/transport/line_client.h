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

/// One program that is connected to a LineServer.
class LineClient {
public:
  explicit LineClient(FileDescriptor socket) : socket_(std::move(socket)) {}

  int socket() const { return socket_.number(); }
  bool isOpen() const { return socket_.isOpen(); }
  /// Returns whether the client may still send something.
  bool isListenedTo() const { return isListenedTo_; }
  bool hasSomethingToSend() const { return !queue_.empty(); }

  /// Appends bytes to send, and returns how many older pieces were dropped.
  std::int64_t push(SharedBytes bytes) { return queue_.push(std::move(bytes)); }
  /// Sends as much as the network takes at once, and returns how many pieces were completed. Closes
  /// the socket on an error.
  std::int64_t sendWaiting();
  /// Reads what has arrived, at most 16 KiB, and returns the complete lines in it, without their
  /// ends. Lines longer than kMaxRemoteBytes are left out. A client that has only closed its own
  /// side still receives.
  std::vector<std::string> receive();

private:
  void addInput(const char* bytes, std::size_t count, std::vector<std::string>& lines);

  FileDescriptor socket_;
  OutgoingQueue queue_;
  std::size_t sent_ = 0; ///< bytes of the first piece
  std::string input_;    ///< the beginning of a line
  bool isTooLong_ = false;
  bool isListenedTo_ = true;
};

} // namespace dewpoint::broadcast
