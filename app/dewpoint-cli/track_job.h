// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace dewpoint::app {

/// `dewpoint-cli track`: runs a project from its first to its last frame and writes what it found.
struct TrackJob {
  std::filesystem::path folder;
  int threads = 1;
  std::int64_t firstFrame = 0;
  std::optional<std::int64_t> endFrame; ///< exclusive

  /// The process's exit code.
  int run(SessionInputs inputs) const;
};

} // namespace dewpoint::app
