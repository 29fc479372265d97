// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/broadcast/message/remote_command.h"
#include "core/broadcast/transport/outlet.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace dewpoint::broadcast {

/// Sends lines to all programs that connect by TCP, and reads remote commands from them, one JSON
/// object per line. It has one thread.
///
/// What comes in is limited: a line longer than kMaxRemoteBytes is ignored up to its end, and up to
/// kMaxClients programs are connected at the same time. A client that is too slow misses lines
/// (OutgoingQueue); one that acknowledges nothing for kUnansweredSeconds is disconnected.
class LineServer final : public Outlet {
public:
  static constexpr std::size_t kMaxClients = 256;
  static constexpr int kUnansweredSeconds = 60;

  /// Opens a port (0: any free one) on an address of this computer. `gate` is never null. BadValue
  /// if the port cannot be opened.
  static Result<std::unique_ptr<LineServer>> open(const std::string& host, std::uint16_t port,
                                                  std::shared_ptr<RemoteGate> gate);
  /// Disconnects all clients.
  ~LineServer() override;

  void setOpening(const std::string& opening) override;
  void send(const std::vector<std::string>& pieces) override;
  OutletReport report() const override;
  /// Returns the port that is open.
  std::uint16_t port() const;

private:
  class Impl;
  explicit LineServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

} // namespace dewpoint::broadcast
