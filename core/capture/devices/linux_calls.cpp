// SPDX-License-Identifier: GPL-3.0-or-later
#ifdef __linux__
#include "core/capture/devices/linux_calls.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace dewpoint::capture {
namespace {

class SystemCalls final : public LinuxCalls {
public:
  int open(const std::string& path) override {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    return descriptor < 0 ? -errno : descriptor;
  }
  void close(int descriptor) override { ::close(descriptor); }
  int callIoctl(int descriptor, unsigned long request, void* argument) override {
    int result = 0;
    do {
      result = ::ioctl(descriptor, request, argument);
    } while (result < 0 && errno == EINTR);
    return result < 0 ? -errno : 0;
  }
};

} // namespace

LinuxCallsPtr linuxCalls() {
  return std::make_shared<SystemCalls>();
}

} // namespace dewpoint::capture
#endif
