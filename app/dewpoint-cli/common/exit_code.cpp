// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/common/exit_code.h"

#include <fmt/format.h>

namespace dewpoint::app {

int reportError(const Error& error) {
  fmt::print(stderr, "dewpoint-cli: {}.\n", errorSentence(error));
  switch (error.code) {
  case ErrorCode::FileUnwritable:
    return kExitOutput;
  case ErrorCode::EndedEarly:
    return kExitEndedEarly;
  case ErrorCode::Canceled:
    return kExitInterrupted;
  default:
    return kExitBadInput;
  }
}

} // namespace dewpoint::app
