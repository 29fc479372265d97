// SPDX-License-Identifier: GPL-3.0-or-later
// How many threads share a job. Results never depend on it.
#pragma once

#include "core/base/floors.h"

#include <cstddef>

namespace dewpoint::base {

/// Threads of the filter when `wanted` are requested; 0: as many as this machine runs at once, but
/// one for cameras and window.
int filterThreads(int wanted);

/// Threads for `tasks` independent tasks: one each, as far as this machine runs them at once; at
/// least 1.
int threadsForTasks(std::size_t tasks);

} // namespace dewpoint::base
