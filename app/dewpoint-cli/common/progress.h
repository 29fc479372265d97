// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <chrono>
#include <cstdint>
#include <string>

namespace dewpoint::app {

/// Progress bar on stderr; silent if stderr is not a terminal.
class Progress {
public:
  /// Creates a progress bar for `total` steps. If `total` is 0, the number of steps is unknown and
  /// only the count is shown.
  Progress(std::string label, std::int64_t total);
  void show(std::int64_t done);
  /// Removes the progress bar, so that later output starts on an empty line.
  void finish();

private:
  std::string label_;
  std::int64_t total_;
  bool terminal_;
  std::chrono::steady_clock::time_point begin_;
  std::chrono::steady_clock::time_point last_{};
};

} // namespace dewpoint::app
