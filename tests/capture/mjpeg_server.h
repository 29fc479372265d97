// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/imgcodecs.hpp>

#include <arpa/inet.h>
#include <cstdint>
#include <functional>
#include <netinet/in.h>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <sys/socket.h>
#include <sys/time.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace dewpoint::tests::test {

/// A network camera on this machine: serves the pictures of a function as multipart MJPEG over
/// HTTP, one every 20 ms, to everyone who connects. Stops, and cuts all connections, with its life.
class MjpegServer {
public:
  using Picture = std::function<cv::Mat(std::int64_t)>;
  using Spoil = std::function<void(std::vector<unsigned char>&)>;

  /// `port`: 0 for any free port. `spoil` may change the bytes of each picture before they are
  /// sent.
  explicit MjpegServer(Picture picture, std::uint16_t port = 0, Spoil spoil = {})
      : picture_(std::move(picture)), spoil_(std::move(spoil)) {
    listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int on = 1;
    ::setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    auto* plain = reinterpret_cast<sockaddr*>(&address);
    socklen_t size = sizeof address;
    if (::bind(listener_, plain, size) != 0 || ::listen(listener_, 8) != 0 ||
        ::getsockname(listener_, plain, &size) != 0) {
      ::close(listener_);
      throw std::runtime_error("the test server gets no port");
    }
    port_ = ntohs(address.sin_port);
    thread_ = std::jthread([this](const std::stop_token& stop) { serve(stop); });
  }
  MjpegServer(const MjpegServer&) = delete;
  MjpegServer& operator=(const MjpegServer&) = delete;
  ~MjpegServer() {
    thread_.request_stop();
    thread_.join();
    for (const int client : clients_) {
      ::close(client);
    }
    ::close(listener_);
  }

  std::uint16_t port() const { return port_; }
  std::string address() const { return "http://127.0.0.1:" + std::to_string(port_) + "/video"; }

private:
  static bool sendAll(int client, const void* data, std::size_t size) {
    const auto* bytes = static_cast<const char*>(data);
    while (size > 0) {
      const auto sent = ::send(client, bytes, size, MSG_NOSIGNAL);
      if (sent <= 0) {
        return false;
      }
      bytes += sent;
      size -= static_cast<std::size_t>(sent);
    }
    return true;
  }

  void greet() {
    const int client = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (client < 0) {
      return;
    }
    const timeval limit{1, 0};
    ::setsockopt(client, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
    ::setsockopt(client, SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
    std::vector<char> request(4096);
    const std::string answer = "HTTP/1.0 200 OK\r\nContent-Type: "
                               "multipart/x-mixed-replace; boundary=frame\r\n\r\n";
    if (::recv(client, request.data(), request.size(), 0) > 0 &&
        sendAll(client, answer.data(), answer.size())) {
      clients_.push_back(client);
    } else {
      ::close(client);
    }
  }

  void serve(const std::stop_token& stop) {
    for (std::int64_t number = 0; !stop.stop_requested(); ++number) {
      pollfd waiting{listener_, POLLIN, 0};
      if (::poll(&waiting, 1, 20) > 0) {
        greet();
      }
      std::vector<unsigned char> jpeg;
      cv::imencode(".jpg", picture_(number), jpeg);
      if (spoil_) {
        spoil_(jpeg);
      }
      const std::string head =
          "--frame\r\nContent-Type: image/jpeg\r\nContent-Length: " + std::to_string(jpeg.size()) +
          "\r\n\r\n";
      std::erase_if(clients_, [&](int client) {
        const bool good = sendAll(client, head.data(), head.size()) &&
                          sendAll(client, jpeg.data(), jpeg.size()) && sendAll(client, "\r\n", 2);
        if (!good) {
          ::close(client);
        }
        return !good;
      });
    }
  }

  Picture picture_;
  Spoil spoil_;
  int listener_ = -1;
  std::uint16_t port_ = 0;
  std::vector<int> clients_;
  std::jthread thread_;
};

} // namespace dewpoint::tests::test
