// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/transport/line_file.h"

#include <climits>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <utility>

namespace dewpoint::broadcast {
namespace {

/// In this thread, a reader that ends is an error of write(), not the end of the program.
void blockPipeSignal() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

} // namespace

Result<std::unique_ptr<LineFile>> LineFile::open(const std::filesystem::path& file) {
  std::unique_ptr<LineFile> made(new LineFile(file));
  made->report_.kind = OutletKind::CsvLines;
  made->report_.address = file.string();
  struct stat status {};
  if (file == "-") {
    made->number_ = STDOUT_FILENO;
    ::fstat(STDOUT_FILENO, &status);
  } else {
    made->isNamed_ = ::stat(file.c_str(), &status) == 0 && S_ISFIFO(status.st_mode);
    if (!made->isNamed_) {
      made->own_ = FileDescriptor(::open(
          file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOCTTY | O_NONBLOCK, 0644));
      made->number_ = made->own_.number();
      if (made->number_ < 0) {
        return failure(ErrorCode::FileUnwritable, file.string(), "", std::strerror(errno));
      }
      ::fstat(made->number_, &status);
    }
  }
  made->isPipe_ = !S_ISREG(status.st_mode);
  return made;
}

void LineFile::setPreamble(const std::string& preamble) {
  isOpened_ = isOpened_ && preamble == preamble_;
  preamble_ = preamble;
}

bool LineFile::isReady() {
  if (number_ < 0 && isNamed_) {
    own_ = FileDescriptor(::open(file_.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC));
    number_ = own_.number();
    isOpened_ = false;
    const std::lock_guard lock(mutex_);
    report_.clientCount = number_ >= 0 ? 1 : 0;
    report_.hasNoReader = number_ < 0;
    report_.problem.clear();
  }
  return number_ >= 0 && !isBroken_;
}

void LineFile::fail(int reason) {
  const std::lock_guard lock(mutex_);
  report_.clientCount = 0;
  report_.hasNoReader = isNamed_ && reason == EPIPE;
  report_.problem = report_.hasNoReader ? "" : std::strerror(reason);
  own_.close();
  number_ = -1;
  isBroken_ = !isNamed_;
}

void LineFile::write(const std::string& piece) {
  // A pipe that is ready takes PIPE_BUF bytes without waiting, and not one line with a gap in it.
  pollfd ready{number_, POLLOUT, 0};
  const bool fits = !isPipe_ || (piece.size() <= PIPE_BUF && ::poll(&ready, 1, 0) == 1 &&
                                 (ready.revents & POLLOUT) != 0);
  const bool hasReader = (ready.revents & (POLLERR | POLLHUP | POLLNVAL)) == 0;
  if (!hasReader) {
    fail(EPIPE);
    return;
  }
  std::size_t done = 0;
  while (fits && done < piece.size()) {
    const auto written = ::write(number_, piece.data() + done, piece.size() - done);
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      break;
    }
    if (written <= 0) {
      fail(written < 0 ? errno : EIO);
      return;
    }
    done += static_cast<std::size_t>(written);
  }
  const std::lock_guard lock(mutex_);
  ++(done == piece.size() ? report_.sentPieceCount : report_.droppedPieceCount);
}

void LineFile::send(const std::vector<std::string>& pieces) {
  blockPipeSignal();
  if (!isReady()) {
    return;
  }
  if (!std::exchange(isOpened_, true) && !preamble_.empty()) {
    write(preamble_);
  }
  for (const std::string& piece : pieces) {
    if (number_ >= 0 && !isBroken_) {
      write(piece);
    }
  }
}

OutletReport LineFile::report() const {
  const std::lock_guard lock(mutex_);
  return report_;
}

} // namespace dewpoint::broadcast
