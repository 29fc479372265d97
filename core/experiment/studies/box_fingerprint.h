// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <map>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Computes fingerprints like suiteFingerprints(), for the methods of boxFollowerNames(). They
/// cover the boxes found with 300 particles on the first images of the rendered clip (first tuning
/// seed), starting from the true first box. An empty list means all methods.
///
/// Boxes are rounded to 0.01 px. NotFound for an unknown method.
Result<std::map<std::string, std::string>> boxFingerprints(const std::vector<std::string>& methods);

} // namespace dewpoint::experiment
