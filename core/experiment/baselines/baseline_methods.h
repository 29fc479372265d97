// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/scenario.h"
#include "core/tracking/tracker.h"

#include <memory>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Returns all methods of the suite in the order of its tables: the methods that a project may
/// choose, ours first (followed by its smoothed variant), then `triangulation`,
/// `triangulation-kalman`, `camshift` and `csrt`.
std::vector<std::string> suiteMethods();

/// Makes a tracker of one of suiteMethods() that knows only what a method may know of the run. For
/// the smoothed method it is the tracker whose estimates are smoothed. NotFound for any other name.
Result<std::unique_ptr<Tracker>> makeSuiteTracker(const std::string& method,
                                                  const ScenarioRun& run);

} // namespace dewpoint::experiment
