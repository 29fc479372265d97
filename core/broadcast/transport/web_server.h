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

/// Sends each piece of a frame (StreamFormat::encode) as a WebSocket text message (RFC 6455) to all
/// clients, and reads remote commands from them. Serves livePage() at `/` on the same port. Uses
/// one thread for all clients.
///
/// Limits: An HTTP request has at most 8 KiB of header and no body, and must be complete within
/// kRequestTimeoutSeconds. A message longer than kMaxRemoteCommandBytes ends the connection. At
/// most kMaxClients clients can be connected at the same time. A client that does not answer a ping
/// within 30 s is disconnected.
///
/// Requests from pages of other web sites are refused; see isAllowedOrigin().
class WebServer final : public PreambleOutlet {
public:
  static constexpr std::size_t kMaxClients = 64;
  static constexpr int kRequestTimeoutSeconds = 10;

  /// Opens a port (0: any free port) on an address of this computer (`host`, which must be
  /// numeric). `gate` executes remote commands and must not be null. `texts`: texts of the page.
  /// Error: BadValue if the port cannot be opened.
  static Result<std::unique_ptr<WebServer>> open(const std::string& host, std::uint16_t port,
                                                 std::shared_ptr<RemoteCommandFilter> gate,
                                                 const PageTexts& texts = {});
  /// Disconnects all clients.
  ~WebServer() override;

  /// Sets the texts of the page. They are used when a browser loads the page the next time.
  /// Thread-safe.
  void setPageTexts(const PageTexts& texts);
  void setPreamble(const std::string& preamble) override;
  void send(const std::vector<std::string>& pieces) override;
  OutletReport report() const override;
  /// Returns the number of the open port.
  std::uint16_t port() const;

private:
  class Impl;
  explicit WebServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Returns whether a request may be answered. `host` and `origin` are the HTTP header fields Host
/// and Origin; `origin` is empty if the request has none, as usual for programs other than
/// browsers. A page may only come from this server: its origin must be `host`. On a loopback
/// address (`isLoopback`), the host must be localhost or a loopback address. Web sites whose name
/// resolves to this computer are therefore refused.
bool isAllowedOrigin(std::string_view host, std::string_view origin, bool isLoopback);

} // namespace dewpoint::broadcast
