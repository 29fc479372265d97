// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <memory>
#include <string>
#include <utility>

namespace dewpoint::capture {

/// System calls for V4L2 device nodes. Tests use another implementation.
class LinuxCalls {
public:
  virtual ~LinuxCalls() = default;
  /// Opens a device node. Returns its file descriptor, or the negative error number.
  virtual int open(const std::string& path) = 0;
  virtual void close(int descriptor) = 0;
  /// Calls ioctl() with one of the requests VIDIOC_...; repeats the call if a signal interrupts it.
  /// Returns 0 or the negative error number.
  virtual int callIoctl(int descriptor, unsigned long request, void* argument) = 0;
};

using LinuxCallsPtr = std::shared_ptr<LinuxCalls>;

/// Returns the implementation that calls the operating system.
LinuxCallsPtr linuxCalls();

/// Open device node. The destructor closes it.
class LinuxNode {
public:
  LinuxNode(LinuxCallsPtr calls, const std::string& path)
      : calls_(std::move(calls)), descriptor_(calls_->open(path)) {}
  LinuxNode(const LinuxNode&) = delete;
  LinuxNode& operator=(const LinuxNode&) = delete;
  ~LinuxNode() {
    if (descriptor_ >= 0) {
      calls_->close(descriptor_);
    }
  }

  /// Returns 0, or the error number of the failed attempt to open the node.
  int openError() const { return descriptor_ < 0 ? -descriptor_ : 0; }
  /// Calls ioctl() for this node. Returns 0 or the error number.
  template <class Argument> int callIoctl(unsigned long request, Argument& argument) {
    return -calls_->callIoctl(descriptor_, request, &argument);
  }

private:
  LinuxCallsPtr calls_;
  int descriptor_;
};

} // namespace dewpoint::capture
