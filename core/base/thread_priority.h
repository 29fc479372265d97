// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::base {

/// Priority of a thread relative to other threads on the same processor.
enum class ThreadPriority {
  Prompt, ///< the normal behavior: a thread runs as soon as it wakes up
  /// A thread that wakes up waits until the thread now running on the processor pauses or its time
  /// slice ends. Threads started by a patient thread are patient, too.
  Patient
};

/// Sets the priority of the calling thread. Has no effect without permission, or on systems other
/// than Linux. UI threads are `Patient`, so that drawing the results of one filter iteration does
/// not delay the next iteration by milliseconds.
void setThreadPriority(ThreadPriority priority);

} // namespace dewpoint::base
