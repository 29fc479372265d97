// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstdint>
#include <string>
#include <sys/socket.h>

namespace dewpoint::broadcast {

/// An address of the network, IPv4 or IPv6.
class SocketAddress {
public:
  /// Looks up a host, which may take seconds for a name. `type` is SOCK_DGRAM or SOCK_STREAM.
  /// BadValue if the host is unknown.
  static Result<SocketAddress> find(const std::string& host, std::uint16_t port, int type);
  /// Reads the address of this computer that a socket is bound to.
  static SocketAddress ofSocket(int socket);

  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&storage_); }
  socklen_t size() const { return size_; }
  int family() const { return storage_.ss_family; }
  std::uint16_t port() const;
  bool isLoopback() const;
  /// Returns HOST:PORT in digits.
  std::string text() const;

private:
  sockaddr_storage storage_{};
  socklen_t size_ = 0;
};

} // namespace dewpoint::broadcast
