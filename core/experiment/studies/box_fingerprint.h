// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <map>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Computes fingerprints like suiteFingerprints(), for methods of boxFollowerNames(). If `methods`
/// is empty, all of them are used. A fingerprint covers the boxes that a method finds, with 300
/// particles, in the first images of the rendered clip (first tuning seed), starting from the true
/// first box.
///
/// Boxes are rounded to 0.01 px. Returns NotFound for an unknown method.
Result<std::map<std::string, std::string>> boxFingerprints(const std::vector<std::string>& methods);

} // namespace dewpoint::experiment
