// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstdint>
#include <string>
#include <sys/socket.h>

namespace dewpoint::broadcast {

/// Network address (IPv4 or IPv6) with a port.
class SocketAddress {
public:
  /// Returns the address of a host and port. Looking up a name may take seconds. `type` is
  /// SOCK_DGRAM or SOCK_STREAM. Error: BadValue if the host is unknown.
  static Result<SocketAddress> find(const std::string& host, std::uint16_t port, int type);
  /// Returns the local address to which a socket is bound.
  static SocketAddress ofSocket(int socket);

  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&storage_); }
  socklen_t size() const { return size_; }
  int family() const { return storage_.ss_family; }
  std::uint16_t port() const;
  bool isLoopback() const;
  /// Returns the address as HOST:PORT, with a numeric host.
  std::string text() const;

private:
  sockaddr_storage storage_{};
  socklen_t size_ = 0;
};

} // namespace dewpoint::broadcast
