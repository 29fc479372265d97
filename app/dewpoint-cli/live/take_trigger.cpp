// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/live/take_trigger.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <poll.h>
#include <unistd.h>

namespace dewpoint::app {

int LineTrigger::take() {
  int lines = 0;
  pollfd input{STDIN_FILENO, POLLIN, 0};
  while (!hasEnded_ && ::poll(&input, 1, 0) > 0) {
    std::array<char, 4096> text{};
    const ssize_t length = ::read(STDIN_FILENO, text.data(), text.size());
    if (length < 0 && errno == EINTR) {
      continue;
    }
    hasEnded_ = length <= 0;
    lines += static_cast<int>(
        std::count(text.begin(), text.begin() + std::max<ssize_t>(0, length), '\n'));
  }
  return lines;
}

} // namespace dewpoint::app
