// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/transport/file_descriptor.h"

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <array>
#include <chrono>
#include <cstdint>
#include <netinet/in.h>
#include <poll.h>
#include <string>
#include <string_view>
#include <sys/socket.h>
#include <thread>

namespace dewpoint::tests {

/// Waits until something is true, and returns whether it is.
template <class Condition> bool becomesTrue(const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!condition() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return condition();
}

/// A client on this computer that connects, or a receiver of datagrams.
class TestSocket {
public:
  static TestSocket connectedTo(std::uint16_t port, int receiveBytes = 0) {
    TestSocket made(SOCK_STREAM);
    if (receiveBytes > 0) {
      ::setsockopt(made.socket_.number(), SOL_SOCKET, SO_RCVBUF, &receiveBytes,
                   sizeof(receiveBytes));
    }
    const sockaddr_in address = localAddress(port);
    EXPECT_EQ(::connect(made.socket_.number(), reinterpret_cast<const sockaddr*>(&address),
                        sizeof(address)),
              0);
    return made;
  }
  static TestSocket receiver() {
    TestSocket made(SOCK_DGRAM);
    const sockaddr_in address = localAddress(0);
    EXPECT_EQ(
        ::bind(made.socket_.number(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)),
        0);
    return made;
  }

  std::uint16_t port() const {
    sockaddr_in address{};
    socklen_t size = sizeof(address);
    ::getsockname(socket_.number(), reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
  }

  /// Returns whether everything could be sent.
  bool send(std::string_view bytes) {
    while (!bytes.empty()) {
      const auto sent = ::send(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent <= 0) {
        return false;
      }
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
  }
  void closeOwnSide() { ::shutdown(socket_.number(), SHUT_WR); }

  /// Reads until the received text contains this one, the other side closes or 20 s are over.
  /// Returns what was received up to the end of this text, or all of it.
  std::string readUntil(std::string_view text) {
    while (received_.find(text) == std::string::npos && readMore()) {
    }
    const auto found = received_.find(text);
    const auto end = found == std::string::npos ? received_.size() : found + text.size();
    std::string read = received_.substr(0, end);
    received_.erase(0, end);
    return read;
  }
  /// Reads until the other side closes; returns whether it does within 20 s.
  bool isClosedByOther() {
    while (readMore()) {
    }
    return isClosed_;
  }

private:
  explicit TestSocket(int type) : socket_(::socket(AF_INET, type, 0)) {}

  static sockaddr_in localAddress(std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
  }
  bool readMore() {
    std::array<char, 65536> bytes;
    pollfd ready{socket_.number(), POLLIN, 0};
    if (::poll(&ready, 1, 20'000) != 1) {
      return false;
    }
    const auto count = ::recv(socket_.number(), bytes.data(), bytes.size(), 0);
    isClosed_ = count <= 0;
    received_.append(bytes.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    return count > 0;
  }

  broadcast::FileDescriptor socket_;
  std::string received_;
  bool isClosed_ = false;
};

} // namespace dewpoint::tests
