// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::base {

/// Priority of a thread among threads that share a processor.
enum class Precedence {
  Prompt, ///< the normal behavior: runs as soon as it wakes up
  Patient ///< waits until a running thread pauses or its time slice ends; new threads inherit it
};

/// Sets the priority of the calling thread (Linux; has no effect elsewhere or where it is not
/// permitted). The window's threads are patient, so that drawing one iteration does not interrupt
/// the next filter iteration for milliseconds.
void setPrecedence(Precedence precedence);

} // namespace dewpoint::base
