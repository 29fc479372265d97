// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace dewpoint::app {

/// What the process returns, as promised by --help.
enum ExitCode {
  kExitDone = 0,
  kExitProblems = 1,   ///< a check found a problem (doctor, self-test)
  kExitUsage = 2,      ///< the command line cannot be understood
  kExitBadInput = 3,   ///< nothing could be computed
  kExitEndedEarly = 4, ///< the input broke off, or results are missing; what there is is kept
  kExitOutput = 5,     ///< the output cannot be written; what was written so far is kept
  kExitInterrupted = 130,
};

/// Prints the error's sentence to stderr and returns the exit code that fits it.
int report(const Error& error);

} // namespace dewpoint::app
