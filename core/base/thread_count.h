// SPDX-License-Identifier: GPL-3.0-or-later
// Number of threads that share a job. Results never depend on it.
#pragma once

#include "core/base/floors.h"

#include <cstddef>

namespace dewpoint::base {

/// Number of threads for the filter when `wanted` are requested. 0 means all hardware threads but
/// one, which is left for cameras and the window.
int filterThreads(int wanted);

/// Number of threads for `tasks` independent tasks: one per task, at most the number of hardware
/// threads, at least 1.
int threadsForTasks(std::size_t tasks);

} // namespace dewpoint::base
