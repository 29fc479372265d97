// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/thread_count.h"

#include <algorithm>
#include <thread>

namespace dewpoint::base {
namespace {

int processors() {
  // hardware_concurrency() is 0 where it is not known.
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

} // namespace

int threadCountForFilter(int wanted) {
  return wanted > 0 ? wanted : std::max(1, processors() - 1);
}

int threadCountForTasks(std::size_t tasks) {
  return static_cast<int>(
      std::clamp(tasks, std::size_t{1}, static_cast<std::size_t>(processors())));
}

} // namespace dewpoint::base
