// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/common/interruption.h"

#include <atomic>
#include <csignal>

namespace dewpoint::app {
namespace {

std::atomic<bool> requested = false;
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

} // namespace

void catchInterruption() {
  std::signal(SIGINT, [](int) { requested = true; });
  std::signal(SIGTERM, [](int) { requested = true; });
}

bool wasInterruptionRequested() {
  return requested;
}

} // namespace dewpoint::app
