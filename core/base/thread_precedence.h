// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::base {

/// Who goes first where threads share a processor.
enum class Precedence {
  Prompt, ///< as usual: takes the processor when it wakes up
  Patient ///< waits until a running thread pauses or has had its turn; new threads inherit it
};

/// Sets it for the calling thread (Linux; nothing happens elsewhere or where it is forbidden). The
/// window's threads are patient, so that a filter iteration is not interrupted for milliseconds to
/// draw the one before.
void setPrecedence(Precedence precedence);

} // namespace dewpoint::base
