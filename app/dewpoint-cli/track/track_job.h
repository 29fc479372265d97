// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/frame_loop.h"
#include "core/session/session_inputs.h"
#include "core/trajectory/jobs/job_record.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace dewpoint::app {

/// `dewpoint-cli track`: runs a project from its first to its last frame and writes what it found.
struct TrackJob {
  std::filesystem::path folder;
  int threads = 1;
  bool reasons = false; ///< write reasons.csv, too
  FrameRange frames;
  JobRecord record; ///< what is known of it before it runs

  /// The process's exit code.
  int run(SessionInputs inputs) const;
};

} // namespace dewpoint::app
