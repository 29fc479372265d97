// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <memory>
#include <string>
#include <utility>

namespace dewpoint::capture {

/// System calls on the nodes of V4L2 devices. Tests replace them.
class LinuxCalls {
public:
  virtual ~LinuxCalls() = default;
  /// Opens a node. Returns its descriptor, or the negative error number.
  virtual int open(const std::string& path) = 0;
  virtual void close(int descriptor) = 0;
  /// ioctl() with one of the requests VIDIOC_..., repeated if a signal interrupts it. Returns 0 or
  /// the negative error number.
  virtual int control(int descriptor, unsigned long request, void* argument) = 0;
};

using LinuxCallsPtr = std::shared_ptr<LinuxCalls>;

/// Returns the calls of the system.
LinuxCallsPtr linuxCalls();

/// An open node, closed at the end.
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
  /// Calls ioctl(). Returns 0 or the error number.
  template <class Argument> int ask(unsigned long request, Argument& argument) {
    return -calls_->control(descriptor_, request, &argument);
  }

private:
  LinuxCallsPtr calls_;
  int descriptor_;
};

} // namespace dewpoint::capture
