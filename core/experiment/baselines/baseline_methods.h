// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/scenario.h"
#include "core/tracking/tracker.h"

#include <memory>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// All methods of the suite, in the order of its tables: the ones a project may choose, ours first
/// (and smoothed after the run), then `triangulation`, `triangulation-kalman`, `camshift` and
/// `csrt`.
std::vector<std::string> suiteMethods();

/// A tracker of one of suiteMethods() that knows what a method may know of the run (for the
/// smoothed one that which it is made from); NotFound for another name.
Result<std::unique_ptr<Tracker>> makeSuiteTracker(const std::string& method,
                                                  const ScenarioRun& run);

} // namespace dewpoint::experiment
