// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/scenario.h"
#include "core/tracking/tracker.h"

#include <memory>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Returns the names of all methods that the accuracy suite compares, in the order of the report's
/// tables. First come the methods that a project can choose, beginning with `dewpoint` and
/// `dewpoint-smoothed`. Then come `triangulation`, `triangulation-kalman`, `camshift` and `csrt`.
std::vector<std::string> suiteMethods();

/// Creates the tracker for one of suiteMethods(). The tracker receives only what a method may know
/// about the run, not the truth. The name `dewpoint-smoothed` gives the tracker of `dewpoint`,
/// because the estimates are smoothed after the run. Returns NotFound for any other name.
Result<std::unique_ptr<Tracker>> makeSuiteTracker(const std::string& method,
                                                  const ScenarioRun& run);

} // namespace dewpoint::experiment
