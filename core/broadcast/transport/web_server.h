// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/broadcast/message/remote_command.h"
#include "core/broadcast/transport/outlet.h"
#include "core/broadcast/transport/page_texts.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace dewpoint::broadcast {

/// Sends each piece as a WebSocket text message (RFC 6455) to all clients, reads remote commands
/// from them, and serves livePage() at `/` on the same port. It has one thread.
///
/// What comes in is limited: 8 KiB of HTTP header, which must be complete within kVisitSeconds; no
/// body; messages of up to kMaxRemoteBytes, where a longer one ends the connection; and kMaxClients
/// connections at the same time. A client that does not answer a ping within 30 s is disconnected.
/// Pages of other sites in a browser are refused by their Origin. A server on a loopback address
/// also refuses requests under another name than localhost, so that a site whose name leads to
/// this computer cannot read from it.
class WebServer final : public Outlet {
public:
  static constexpr std::size_t kMaxClients = 64;
  static constexpr int kVisitSeconds = 10;

  /// Opens a port (0: any free one) on an address of this computer, which must be in digits. `gate`
  /// is never null. `texts`: those of the page. BadValue if the port cannot be opened.
  static Result<std::unique_ptr<WebServer>> open(const std::string& host, std::uint16_t port,
                                                 std::shared_ptr<RemoteGate> gate,
                                                 const PageTexts& texts = {});
  /// Disconnects all clients.
  ~WebServer() override;

  /// Sets the texts of pages that are loaded from now on. May be called by any thread.
  void setPageTexts(const PageTexts& texts);
  void setOpening(const std::string& opening) override;
  void send(const std::vector<std::string>& pieces) override;
  OutletReport report() const override;
  /// Returns the port that is open.
  std::uint16_t port() const;

private:
  class Impl;
  explicit WebServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Returns whether a browser's request may be answered: `host` and `origin` are the header fields
/// of these names, where a program that is no browser sends no Origin.
bool isAllowedOrigin(std::string_view host, std::string_view origin, bool isLoopback);

} // namespace dewpoint::broadcast
