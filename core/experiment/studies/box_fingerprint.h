// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <map>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// As suiteFingerprints(), of boxFollowerNames(): the boxes of 300 particles on the first
/// images of the rendered clip (the first tuning seed), from the true box of the first one. All
/// methods for none.
///
/// Rounded: boxes to 0.01 px. NotFound for a method that does not exist.
Result<std::map<std::string, std::string>> boxFingerprints(const std::vector<std::string>& methods);

} // namespace dewpoint::experiment
