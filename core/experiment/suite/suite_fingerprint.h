// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <map>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Returns a checksum (fingerprint) of each method's results, by method name. It covers errors,
/// NEES and P(exists) in a few short, fixed runs of the suite with tuning seeds. A refactoring that
/// keeps the results does not change the fingerprint; a change of the method, the scenarios or the
/// computation of errors does. Effects that only appear in longer runs are not covered.
///
/// Errors are rounded to 0.01 mm, NEES to three digits, sums of P(exists) to 0.001. Only targets
/// that a method declares present count. Returns NotFound for an unknown method or scenario.
Result<std::map<std::string, std::string>>
suiteFingerprints(const std::vector<std::string>& methods);

} // namespace dewpoint::experiment
