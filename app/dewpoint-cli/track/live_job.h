// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/output_settings.h"
#include "core/session/session_inputs.h"

#include <filesystem>
#include <optional>
#include <set>
#include <string>

namespace dewpoint::app {

/// Implements `dewpoint-cli live`: tracks a project in real time and sends the results to other
/// programs. If a folder is set, also writes the results to this folder.
struct LiveJob {
  std::optional<std::filesystem::path> folder; ///< output folder; not set: nothing is written
  /// Duration of the run; not set: until the input ends or the user interrupts it.
  std::optional<double> maxSeconds;
  OutputSettings output;
  std::filesystem::path projectFile; ///< paths in `output` are relative to the folder of this file
  std::set<std::string> keysFromCommandLine; ///< keys of `output` that the command line has set

  /// Returns an error about `output`, completed with the command-line option or the project file
  /// that contains the wrong value.
  Error withLocation(Error error) const;

  /// Runs the job and returns the exit code of the process.
  int run(SessionInputs inputs) const;
};

} // namespace dewpoint::app
