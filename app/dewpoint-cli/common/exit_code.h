// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace dewpoint::app {

/// Exit codes of the process, as documented by --help.
enum ExitCode {
  kExitDone = 0,
  kExitProblems = 1,   ///< a check found a problem (doctor, self-test, take check)
  kExitUsage = 2,      ///< the command line is invalid
  kExitBadInput = 3,   ///< nothing could be computed from the input
  kExitEndedEarly = 4, ///< the input ended early, or results are missing; existing results are kept
  kExitOutput = 5,     ///< the output cannot be written; what was written so far is kept
  kExitInterrupted = 130,
};

/// Prints an error as a sentence to stderr and returns its exit code.
int reportError(const Error& error);

} // namespace dewpoint::app
