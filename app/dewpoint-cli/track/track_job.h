// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/frame_loop.h"
#include "core/session/session_inputs.h"
#include "core/trajectory/jobs/job_record.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace dewpoint::app {

/// Implements `dewpoint-cli track`: tracks a project over a range of frames and writes the results.
struct TrackJob {
  std::filesystem::path folder;
  int threadCount = 1;
  bool writesReasonsFile = false; ///< true to also write reasons.csv
  FrameRange frames;
  JobRecord record; ///< identity of the job, which does not depend on its results

  /// Runs the job and returns the exit code of the process.
  int run(SessionInputs inputs) const;
};

} // namespace dewpoint::app
