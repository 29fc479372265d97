// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/scenario.h"
#include "core/tracking/tracker.h"

#include <memory>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Returns the names of all suite methods in table order. First come the methods that a project can
/// choose, beginning with ours and its smoothed variant. Then come `triangulation`,
/// `triangulation-kalman`, `camshift` and `csrt`.
std::vector<std::string> suiteMethods();

/// Creates the tracker for one of suiteMethods(). It receives only what a method may know about the
/// run. For the smoothed method, this is the tracker whose estimates are smoothed. NotFound for any
/// other name.
Result<std::unique_ptr<Tracker>> makeSuiteTracker(const std::string& method,
                                                  const ScenarioRun& run);

} // namespace dewpoint::experiment
