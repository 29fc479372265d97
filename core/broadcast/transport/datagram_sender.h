// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/broadcast/transport/file_descriptor.h"
#include "core/broadcast/transport/outlet.h"

#include <atomic>
#include <memory>
#include <string>

namespace dewpoint::broadcast {

/// Sends each piece of a frame (StreamFormat::encode) as one UDP datagram to one receiver. Does not
/// notice if there is no receiver.
class DatagramSender final : public Outlet {
public:
  /// Opens a socket for sending to `address` (HOST:PORT, which may be a broadcast or multicast
  /// address). `kind` is used in the report. Error: BadValue if the address is unknown.
  static Result<std::unique_ptr<DatagramSender>> open(const std::string& address, OutletKind kind);

  void send(const std::vector<std::string>& pieces) override;
  OutletReport report() const override;

private:
  DatagramSender(FileDescriptor socket, OutletKind kind, std::string address)
      : socket_(std::move(socket)), kind_(kind), address_(std::move(address)) {}

  FileDescriptor socket_;
  OutletKind kind_;
  std::string address_;
  std::atomic<std::int64_t> sent_ = 0;
  std::atomic<std::int64_t> dropped_ = 0;
};

} // namespace dewpoint::broadcast
