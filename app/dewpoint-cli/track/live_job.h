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

/// Implements `dewpoint-cli live`: tracks a project in real time, sends the results to other
/// programs, and writes them if there is a folder.
struct LiveJob {
  std::optional<std::filesystem::path> folder; ///< not set: nothing is written
  std::optional<double> seconds;               ///< not set: until the end or an interruption
  OutputSettings output;
  std::filesystem::path projectFile; ///< relative paths in `output` are relative to its folder
  std::set<std::string> options;     ///< keys of `output` that the command line has set

  /// Returns an error about `output` with the option or the project file that it comes from.
  Error located(Error error) const;

  /// Runs the job and returns the exit code of the process.
  int run(SessionInputs inputs) const;
};

} // namespace dewpoint::app
