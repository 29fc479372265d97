// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/transport/line_server.h"

#include "core/broadcast/transport/line_client.h"
#include "core/broadcast/transport/socket_address.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <deque>
#include <fcntl.h>
#include <list>
#include <mutex>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <thread>
#include <utility>

namespace dewpoint::broadcast {
namespace {

constexpr int kWaitingConnections = 128;
/// Pieces between two turns of the thread, which has nothing to wait for.
constexpr std::size_t kMaxPending = 4096;

void setOption(int socket, int level, int option, int value) {
  ::setsockopt(socket, level, option, &value, sizeof(value));
}

/// A client that has gone without a word is noticed.
void watchConnection(int socket) {
  constexpr int kIdleSeconds = 20;
  constexpr int kProbes = 4;
  constexpr int kBufferBytes = 1 << 17; // more would only make a slow client see older results
  setOption(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  setOption(socket, IPPROTO_TCP, TCP_KEEPIDLE, kIdleSeconds);
  setOption(socket, IPPROTO_TCP, TCP_KEEPINTVL, kIdleSeconds / 2);
  setOption(socket, IPPROTO_TCP, TCP_KEEPCNT, kProbes);
  setOption(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, 1000 * LineServer::kAcknowledgeTimeoutSeconds);
  setOption(socket, IPPROTO_TCP, TCP_NODELAY, 1);
  setOption(socket, SOL_SOCKET, SO_SNDBUF, kBufferBytes);
}

Result<FileDescriptor> listeningSocket(const std::string& host, std::uint16_t port) {
  const auto address = SocketAddress::find(host, port, SOCK_STREAM);
  if (!address) {
    return tl::make_unexpected(address.error());
  }
  FileDescriptor socket(::socket(address->family(), SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (socket.isOpen()) {
    setOption(socket.number(), SOL_SOCKET, SO_REUSEADDR, 1);
  }
  if (!socket.isOpen() || ::bind(socket.number(), address->get(), address->size()) != 0 ||
      ::listen(socket.number(), kWaitingConnections) != 0) {
    return failure(ErrorCode::BadValue, "", "",
                   "port " + std::to_string(port) + " on " + host +
                       " cannot be opened: " + std::strerror(errno));
  }
  return socket;
}

} // namespace

class LineServer::Impl {
public:
  Impl(FileDescriptor listening, FileDescriptor wake, std::shared_ptr<RemoteCommandFilter> gate)
      : listening_(std::move(listening)), wake_(std::move(wake)), gate_(std::move(gate)),
        address_(SocketAddress::ofSocket(listening_.number())),
        thread_([this](const std::stop_token& stop) { run(stop); }) {}
  ~Impl() {
    thread_.request_stop();
    wake();
  }

  void setPreamble(const std::string& preamble) {
    {
      const std::lock_guard lock(mutex_);
      if (preamble == preamble_) {
        return;
      }
      preamble_ = preamble;
    }
    send({preamble});
  }

  void send(const std::vector<std::string>& pieces) {
    {
      const std::lock_guard lock(mutex_);
      for (const std::string& piece : pieces) {
        if (pending_.size() >= kMaxPending) {
          pending_.pop_front();
          ++dropped_;
        }
        pending_.push_back(std::make_shared<const std::string>(piece));
      }
    }
    wake();
  }

  OutletReport report() const {
    return {OutletKind::JsonLines, address_.text(), clientCount_, sent_, dropped_};
  }
  std::uint16_t port() const { return address_.port(); }

private:
  void wake() {
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written = ::write(wake_.number(), &one, sizeof(one));
  }

  void run(const std::stop_token& stop) {
    std::vector<pollfd> polled;
    while (!stop.stop_requested()) {
      polled.assign({{wake_.number(), POLLIN, 0}, {listening_.number(), POLLIN, 0}});
      for (const LineClient& client : clients_) {
        const int events =
            (client.maySendCommands() ? POLLIN : 0) | (client.hasWaitingBytes() ? POLLOUT : 0);
        polled.push_back({client.socket(), static_cast<short>(events), 0});
      }
      ::poll(polled.data(), polled.size(), -1);
      distribute();
      std::size_t k = 2;
      for (LineClient& client : clients_) {
        serve(client, polled[k++].revents);
      }
      // Several at once, but not for as long as somebody connects.
      for (int taken = 0; polled[1].revents != 0 && taken < kWaitingConnections && accept();
           ++taken) {
      }
      std::erase_if(clients_, [](const LineClient& client) { return !client.isOpen(); });
      clientCount_ = static_cast<int>(clients_.size());
    }
  }

  /// Gives all clients what was sent since the last turn.
  void distribute() {
    std::uint64_t count = 0;
    [[maybe_unused]] const auto read = ::read(wake_.number(), &count, sizeof(count));
    std::deque<SharedBytes> pending;
    {
      const std::lock_guard lock(mutex_);
      pending.swap(pending_);
    }
    for (const SharedBytes& piece : pending) {
      for (LineClient& client : clients_) {
        dropped_ += client.push(piece);
      }
    }
  }

  void serve(LineClient& client, int events) {
    if ((events & (POLLIN | POLLERR)) != 0) {
      for (const std::string& line : client.receive()) {
        if (const std::string reply = gate_->handle(line); !reply.empty()) {
          dropped_ += client.push(std::make_shared<const std::string>(reply + "\n"));
        }
      }
    }
    if (client.isOpen() && (events & (POLLHUP | POLLNVAL)) != 0) {
      client = LineClient(FileDescriptor()); // both sides are closed
    } else if (client.isOpen()) {
      sent_ += client.sendWaiting();
    }
  }

  /// Returns whether there was a connection.
  bool accept() {
    FileDescriptor socket(
        ::accept4(listening_.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (!socket.isOpen()) {
      if (errno == EMFILE || errno == ENFILE) {
        // Until a descriptor is free, the connection would wake the thread all the time.
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      }
      return false;
    }
    if (clients_.size() >= kMaxClients) {
      return true;
    }
    watchConnection(socket.number());
    LineClient& client = clients_.emplace_back(std::move(socket));
    const std::lock_guard lock(mutex_);
    if (!preamble_.empty()) {
      client.push(std::make_shared<const std::string>(preamble_));
    }
    return true;
  }

  FileDescriptor listening_;
  FileDescriptor wake_;
  std::shared_ptr<RemoteCommandFilter> gate_;
  SocketAddress address_;
  std::list<LineClient> clients_; ///< of the thread
  std::mutex mutex_;              ///< of the next two
  std::deque<SharedBytes> pending_;
  std::string preamble_;
  std::atomic<int> clientCount_ = 0;
  std::atomic<std::int64_t> sent_ = 0;
  std::atomic<std::int64_t> dropped_ = 0;
  std::jthread thread_; // last: joined before the others go
};

Result<std::unique_ptr<LineServer>> LineServer::open(const std::string& host, std::uint16_t port,
                                                     std::shared_ptr<RemoteCommandFilter> gate) {
  auto listening = listeningSocket(host, port);
  if (!listening) {
    return tl::make_unexpected(listening.error());
  }
  FileDescriptor wake(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC));
  if (!wake.isOpen()) {
    return failure(ErrorCode::BadValue, "", "", std::strerror(errno));
  }
  return std::unique_ptr<LineServer>(new LineServer(
      std::make_unique<Impl>(std::move(*listening), std::move(wake), std::move(gate))));
}

LineServer::LineServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LineServer::~LineServer() = default;

void LineServer::setPreamble(const std::string& preamble) {
  impl_->setPreamble(preamble);
}
void LineServer::send(const std::vector<std::string>& pieces) {
  impl_->send(pieces);
}
OutletReport LineServer::report() const {
  return impl_->report();
}
std::uint16_t LineServer::port() const {
  return impl_->port();
}

} // namespace dewpoint::broadcast
