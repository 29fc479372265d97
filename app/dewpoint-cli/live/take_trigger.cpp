// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/live/take_trigger.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <poll.h>
#include <unistd.h>

namespace dewpoint::app {

Status TakeTrigger::receive(const broadcast::RemoteCommand& command) {
  using broadcast::RemoteAction;
  const auto refused = [](const char* reason) {
    return failure(ErrorCode::BadValue, "", "command", reason);
  };
  std::scoped_lock lock(mutex_);
  switch (command.action) {
  case RemoteAction::StartRecording:
    if (stage_ != Stage::Waiting) {
      return refused("the take has already started");
    }
    stage_ = Stage::Started;
    name_ = command.name;
    return {};
  case RemoteAction::StopRecording:
    if (stage_ != Stage::Started) {
      return refused("no take is in progress");
    }
    stage_ = Stage::Stopped;
    return {};
  case RemoteAction::Start:
  case RemoteAction::Stop:
    break;
  }
  return refused("this program only records; use record and stop-recording");
}

bool TakeTrigger::mustStartTake() {
  const bool isLine = readPendingLines() > 0;
  std::scoped_lock lock(mutex_);
  if (isLine && stage_ == Stage::Waiting) {
    stage_ = Stage::Started;
  }
  return stage_ != Stage::Waiting;
}

bool TakeTrigger::mustStopTake() {
  const bool isLine = readPendingLines() > 0;
  std::scoped_lock lock(mutex_);
  if (isLine) {
    stage_ = Stage::Stopped;
  }
  return stage_ == Stage::Stopped;
}

std::string TakeTrigger::name() const {
  std::scoped_lock lock(mutex_);
  return name_;
}

int TakeTrigger::readPendingLines() {
  int lines = 0;
  pollfd input{STDIN_FILENO, POLLIN, 0};
  while (!hasInputEnded_ && ::poll(&input, 1, 0) > 0) {
    std::array<char, 4096> text{};
    const ssize_t length = ::read(STDIN_FILENO, text.data(), text.size());
    if (length < 0 && errno == EINTR) {
      continue;
    }
    hasInputEnded_ = length <= 0;
    lines += static_cast<int>(
        std::count(text.begin(), text.begin() + std::max<ssize_t>(0, length), '\n'));
  }
  return lines;
}

} // namespace dewpoint::app
