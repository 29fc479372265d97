// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::base {

/// Priority of a thread relative to other threads on the same processor.
enum class ThreadPriority {
  Prompt, ///< the normal behavior: runs as soon as it wakes up
  /// When it wakes up, waits until the running thread pauses or its time slice ends; threads that a
  /// patient thread starts are patient, too.
  Patient
};

/// Sets the priority of the calling thread (Linux only; elsewhere, or without permission, it has no
/// effect). UI threads are `Patient`, so that drawing one iteration does not delay the next filter
/// iteration by milliseconds.
void setThreadPriority(ThreadPriority priority);

} // namespace dewpoint::base
