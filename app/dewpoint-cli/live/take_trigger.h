// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::app {

/// Lines of standard input as a trigger: each line, whatever is in it, is one signal.
class LineTrigger {
public:
  /// Returns how many lines have come since the last call, without waiting.
  int take();
  /// Returns whether standard input has ended.
  bool hasEnded() const { return hasEnded_; }

private:
  bool hasEnded_ = false;
};

} // namespace dewpoint::app
