// SPDX-License-Identifier: GPL-3.0-or-later
// What programs elsewhere send to the outputs: remote commands in lines, the requests of a browser,
// and what it sends by WebSocket.
#include "core/broadcast/message/remote_command.h"
#include "core/broadcast/transport/file_descriptor.h"
#include "core/broadcast/transport/line_client.h"
#include "core/broadcast/transport/web_server.h"
#include "tests/fuzz/expectation.h"
#include "tests/fuzz/fuzzed_readers.h"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <chrono>
#include <memory>
#include <netinet/in.h>
#include <poll.h>
#include <string>
#include <sys/socket.h>

namespace dewpoint::tests {
namespace {

constexpr const char* kToken = "secret";
/// In which a server has to end a connection whose other side is closed: far more than it needs.
constexpr int kAnswerMilliseconds = 30'000;

broadcast::RemoteReceiver acceptingReceiver() {
  return [](const broadcast::RemoteCommand& command) -> Status {
    expect(command.token == kToken, "a command with a wrong token was executed");
    expect(command.name.size() <= broadcast::kMaxRecordingName &&
               command.name.find_first_of("/.") == std::string::npos,
           "a recording has a name that is a path");
    return {};
  };
}

void expectReply(const std::string& reply) {
  expect(reply.starts_with('{') && reply.ends_with('}') && reply.find('\n') == reply.npos,
         "a reply is not one line with a JSON object");
}

/// A server of this process.
class FuzzedServer {
public:
  FuzzedServer() {
    auto opened = broadcast::WebServer::open(
        "127.0.0.1", 0,
        std::make_shared<broadcast::RemoteCommandFilter>(kToken, acceptingReceiver()));
    expect(opened.has_value(), "the server does not open");
    server_ = std::move(*opened);
  }

  /// Sends bytes over a new connection, closes its own side, and returns the answer.
  std::string ask(std::string_view bytes) const {
    const broadcast::FileDescriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(server_->port());
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    expect(::connect(socket.number(), reinterpret_cast<const sockaddr*>(&address),
                     sizeof(address)) == 0,
           "the server takes no connection");
    while (!bytes.empty()) {
      const auto sent = ::send(socket.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent < 0 && errno != EINTR) {
        break; // it may have had enough
      }
      bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(0, sent)));
    }
    ::shutdown(socket.number(), SHUT_WR);
    std::string answer;
    while (readMore(socket.number(), answer)) {
    }
    return answer;
  }

private:
  /// Returns false once the server has ended the connection.
  static bool readMore(int socket, std::string& answer) {
    pollfd ready{socket, POLLIN, 0};
    int count = -1;
    do { // libFuzzer's alarm interrupts it
      count = ::poll(&ready, 1, kAnswerMilliseconds);
    } while (count < 0 && errno == EINTR);
    expect(count == 1, "the server does not end a connection");
    std::array<char, 16'384> piece{};
    const auto bytes = ::recv(socket, piece.data(), piece.size(), 0);
    if (bytes > 0) {
      answer.append(piece.data(), static_cast<std::size_t>(bytes));
    }
    return bytes > 0 || (bytes < 0 && errno == EINTR);
  }

  std::unique_ptr<broadcast::WebServer> server_;
};

const FuzzedServer& fuzzedServer() {
  static const FuzzedServer kServer;
  return kServer;
}

} // namespace

void fuzzRemoteLines(std::string_view bytes) {
  static std::chrono::steady_clock::time_point now{};
  static broadcast::RemoteCommandFilter gate(kToken, acceptingReceiver());
  std::array<int, 2> ends{};
  expect(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0, "no sockets");
  broadcast::FileDescriptor sender(ends[0]);
  broadcast::LineClient client{broadcast::FileDescriptor(ends[1])};
  while (client.maySendCommands() && client.isOpen()) {
    const std::string_view piece = bytes.substr(0, 4000); // fits into the socket
    bytes.remove_prefix(piece.size());
    if (!piece.empty()) {
      expect(::send(sender.number(), piece.data(), piece.size(), MSG_NOSIGNAL) ==
                 static_cast<ssize_t>(piece.size()),
             "the socket does not take a piece");
    } else {
      sender.close();
    }
    for (const std::string& line : client.receive()) {
      expect(line.size() <= broadcast::kMaxRemoteCommandBytes && line.find('\n') == line.npos,
             "what was received is not one short line");
      now += broadcast::RemoteCommandFilter::kLockoutTime; // so that wrong tokens do not end the
                                                           // reading
      expectReply(gate.handle(line, now));
    }
  }
}

void fuzzWebRequest(std::string_view bytes) {
  const std::string answer = fuzzedServer().ask(bytes);
  expect(answer.empty() || answer.starts_with("HTTP/1."), "an answer that is not HTTP");
}

void fuzzWebSocket(std::string_view bytes) {
  static constexpr std::string_view kRequest =
      "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
      "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: 13\r\n\r\n";
  const std::string answer = fuzzedServer().ask(std::string(kRequest) + std::string(bytes));
  expect(answer.starts_with("HTTP/1.1 101 "), "the server refuses a WebSocket");
}

} // namespace dewpoint::tests
