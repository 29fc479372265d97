// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/session_inputs.h"

#include <algorithm>
#include <thread>

namespace dewpoint::session {

int filterThreads(int wanted) {
  // hardware_concurrency() is 0 where it is not known.
  return wanted > 0 ? wanted
                    : std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
}

} // namespace dewpoint::session
