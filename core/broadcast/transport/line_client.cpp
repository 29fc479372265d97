// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/transport/line_client.h"

#include "core/broadcast/message/remote_command.h"

#include <array>
#include <cerrno>
#include <sys/socket.h>

namespace dewpoint::broadcast {

std::int64_t LineClient::sendWaiting() {
  std::int64_t completed = 0;
  while (isOpen() && !queue_.empty()) {
    const std::string& piece = *queue_.front();
    const auto sent =
        ::send(socket(), piece.data() + sent_, piece.size() - sent_, MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) {
      continue;
    }
    if (sent < 0) {
      if (errno != EAGAIN && errno != EWOULDBLOCK) {
        socket_.close();
      }
      break;
    }
    sent_ += static_cast<std::size_t>(sent);
    if (sent_ == piece.size()) {
      queue_.pop();
      sent_ = 0;
      ++completed;
    }
  }
  return completed;
}

void LineClient::addInput(const char* bytes, std::size_t count, std::vector<std::string>& lines) {
  for (std::size_t k = 0; k < count; ++k) {
    if (bytes[k] == '\n') {
      if (!isTooLong_ && !input_.empty()) {
        lines.push_back(input_);
      }
      input_.clear();
      isTooLong_ = false;
    } else if (input_.size() < kMaxRemoteCommandBytes) {
      input_ += bytes[k];
    } else {
      isTooLong_ = true;
    }
  }
}

std::vector<std::string> LineClient::receive() {
  std::vector<std::string> lines;
  std::array<char, std::size_t{16} << 10U> bytes;
  const auto count = ::recv(socket(), bytes.data(), bytes.size(), MSG_DONTWAIT);
  if (count > 0) {
    addInput(bytes.data(), static_cast<std::size_t>(count), lines);
  } else if (count == 0) {
    maySendCommands_ = false;
  } else if (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR) {
    socket_.close();
  }
  return lines;
}

} // namespace dewpoint::broadcast
