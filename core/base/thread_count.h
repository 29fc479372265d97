// SPDX-License-Identifier: GPL-3.0-or-later
// Number of threads that share a job. Results never depend on this number.
#pragma once

#include "core/base/floors.h"

#include <cstddef>

namespace dewpoint::base {

/// Returns the number of threads for the filter: `wanted`, or, if `wanted` is 0, the number of
/// hardware threads minus one. One hardware thread is left for the cameras and the user interface.
int threadCountForFilter(int wanted);

/// Returns the number of threads for `tasks` independent tasks: one per task, but at least 1 and at
/// most the number of hardware threads.
int threadCountForTasks(std::size_t tasks);

} // namespace dewpoint::base
