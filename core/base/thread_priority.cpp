// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/thread_priority.h"

#ifdef __linux__
#include <sched.h>
#endif

namespace dewpoint::base {

void setThreadPriority([[maybe_unused]] ThreadPriority priority) {
#ifdef __linux__
  // A thread of SCHED_BATCH has the same share of the time, but does not interrupt others when it
  // wakes up (sched(7)). No privilege is needed in either direction.
  const sched_param none{};
  sched_setscheduler(0, priority == ThreadPriority::Patient ? SCHED_BATCH : SCHED_OTHER, &none);
#endif
}

} // namespace dewpoint::base
