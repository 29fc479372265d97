// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/transport/socket_address.h"

#include <cstring>
#include <memory>
#include <netdb.h>
#include <netinet/in.h>

namespace dewpoint::broadcast {
namespace {

struct AddressInfoDeleter {
  void operator()(addrinfo* info) const { ::freeaddrinfo(info); }
};

} // namespace

Result<SocketAddress> SocketAddress::find(const std::string& host, std::uint16_t port, int type) {
  addrinfo hints{};
  hints.ai_socktype = type;
  hints.ai_flags = AI_NUMERICSERV;
  addrinfo* first = nullptr;
  const int problem = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &first);
  const std::unique_ptr<addrinfo, AddressInfoDeleter> found(first);
  if (problem != 0 || !found || found->ai_addrlen > sizeof(sockaddr_storage)) {
    return failure(ErrorCode::BadValue, "", "",
                   "the host " + host + " is unknown: " + ::gai_strerror(problem));
  }
  SocketAddress address;
  std::memcpy(&address.storage_, found->ai_addr, found->ai_addrlen);
  address.size_ = found->ai_addrlen;
  return address;
}

SocketAddress SocketAddress::ofSocket(int socket) {
  SocketAddress address;
  address.size_ = sizeof(address.storage_);
  if (::getsockname(socket, reinterpret_cast<sockaddr*>(&address.storage_), &address.size_) != 0) {
    address.size_ = 0;
  }
  return address;
}

std::uint16_t SocketAddress::port() const {
  if (family() == AF_INET6) {
    return ntohs(reinterpret_cast<const sockaddr_in6*>(&storage_)->sin6_port);
  }
  return ntohs(reinterpret_cast<const sockaddr_in*>(&storage_)->sin_port);
}

bool SocketAddress::isLoopback() const {
  if (family() == AF_INET6) {
    return IN6_IS_ADDR_LOOPBACK(&reinterpret_cast<const sockaddr_in6*>(&storage_)->sin6_addr);
  }
  constexpr std::uint32_t kLoopbackNetwork = 127;
  const auto* address = reinterpret_cast<const sockaddr_in*>(&storage_);
  return family() == AF_INET && ntohl(address->sin_addr.s_addr) >> 24U == kLoopbackNetwork;
}

std::string SocketAddress::text() const {
  char host[NI_MAXHOST] = "";
  char port[NI_MAXSERV] = "";
  ::getnameinfo(get(), size_, host, sizeof(host), port, sizeof(port),
                NI_NUMERICHOST | NI_NUMERICSERV);
  const std::string shown = host;
  return (family() == AF_INET6 ? "[" + shown + "]" : shown) + ":" + port;
}

} // namespace dewpoint::broadcast
