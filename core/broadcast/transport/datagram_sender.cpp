// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/transport/datagram_sender.h"

#include "core/broadcast/transport/socket_address.h"
#include "core/project/project_output.h"

#include <cerrno>
#include <cstring>
#include <sys/socket.h>
#include <utility>

namespace dewpoint::broadcast {

Result<std::unique_ptr<DatagramSender>> DatagramSender::open(const std::string& address,
                                                             OutletKind kind) {
  const auto parsed = parseOutputAddress(address);
  if (!parsed) {
    return tl::make_unexpected(parsed.error());
  }
  const auto found = SocketAddress::find(parsed->host, parsed->port, SOCK_DGRAM);
  if (!found) {
    return tl::make_unexpected(found.error());
  }
  FileDescriptor socket(::socket(found->family(), SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  const int on = 1;
  if (socket.isOpen()) {
    ::setsockopt(socket.number(), SOL_SOCKET, SO_BROADCAST, &on, sizeof(on));
  }
  if (!socket.isOpen() || ::connect(socket.number(), found->get(), found->size()) != 0) {
    return failure(ErrorCode::BadValue, "", "",
                   "nothing can be sent to " + address + ": " + std::strerror(errno));
  }
  return std::unique_ptr<DatagramSender>(new DatagramSender(std::move(socket), kind, address));
}

void DatagramSender::send(const std::vector<std::string>& pieces) {
  for (const std::string& piece : pieces) {
    // A receiver that does not exist is reported with the next datagram, which is then sent again.
    bool done = false;
    for (int attempt = 0; attempt < 2 && !done; ++attempt) {
      done = ::send(socket_.number(), piece.data(), piece.size(), MSG_DONTWAIT | MSG_NOSIGNAL) >= 0;
      if (!done && errno != ECONNREFUSED) {
        break;
      }
    }
    ++(done ? sent_ : dropped_);
  }
}

OutletReport DatagramSender::report() const {
  return {kind_, address_, 0, sent_, dropped_};
}

} // namespace dewpoint::broadcast
