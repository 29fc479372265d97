// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <map>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Fingerprint of the results of each method: its errors, NEES and P(exists) on a few short fixed
/// runs of the suite, with tuning seeds. It stays the same when sources are rearranged. It changes
/// when results change, because of the method, the scenarios or the measurement of errors. It does
/// not cover effects that only longer runs show.
///
/// Errors are rounded to 0.01 mm, NEES to three digits, sums of P(exists) to 0.001. Only targets
/// that a method declares present count. NotFound for an unknown method or scenario.
Result<std::map<std::string, std::string>>
suiteFingerprints(const std::vector<std::string>& methods);

} // namespace dewpoint::experiment
