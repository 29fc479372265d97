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

/// Sends lines to all programs that connect by TCP, and reads remote commands from them. A command
/// is one JSON object per line. Uses one thread for all clients.
///
/// At most kMaxClients programs can be connected at the same time. A received line longer than
/// kMaxRemoteCommandBytes is ignored. If a client is too slow, lines for this client are dropped
/// (OutgoingQueue). A client that does not acknowledge data for kAcknowledgeTimeoutSeconds is
/// disconnected.
class LineServer final : public PreambleOutlet {
public:
  static constexpr std::size_t kMaxClients = 256;
  static constexpr int kAcknowledgeTimeoutSeconds = 60;

  /// Opens a port (0: any free port) on an address of this computer (`host`). `gate` executes
  /// remote commands and must not be null. Error: BadValue if the port cannot be opened.
  static Result<std::unique_ptr<LineServer>> open(const std::string& host, std::uint16_t port,
                                                  std::shared_ptr<RemoteCommandFilter> gate);
  /// Disconnects all clients.
  ~LineServer() override;

  void setPreamble(const std::string& preamble) override;
  void send(const std::vector<std::string>& pieces) override;
  OutletReport report() const override;
  /// Returns the number of the open port.
  std::uint16_t port() const;

private:
  class Impl;
  explicit LineServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

} // namespace dewpoint::broadcast
