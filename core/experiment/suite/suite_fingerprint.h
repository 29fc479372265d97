// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <map>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// By method, the fingerprint of what it computes: its errors, its NEES and its P(exists) on a few
/// short fixed runs of the suite, of tuning seeds. It stays when sources are rearranged and changes
/// when results do, be it by the method, by the scenarios or by how errors are measured. It knows
/// nothing of what only longer runs show.
///
/// Rounded: errors to 0.01 mm, NEES to three digits, sums of P(exists) to 0.001. Only what a method
/// declares counts. NotFound for a method or a scenario that does not exist.
Result<std::map<std::string, std::string>>
suiteFingerprints(const std::vector<std::string>& methods);

} // namespace dewpoint::experiment
