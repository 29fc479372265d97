// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/common/interruption.h"

#include <atomic>
#include <csignal>

namespace dewpoint::app {
namespace {

std::atomic<bool> asked = false;
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

} // namespace

void heedInterruption() {
  std::signal(SIGINT, [](int) { asked = true; });
  std::signal(SIGTERM, [](int) { asked = true; });
}

bool interruptionAsked() {
  return asked;
}

} // namespace dewpoint::app
