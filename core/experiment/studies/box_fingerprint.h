// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <map>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Returns a checksum (fingerprint) of the results of each of the methods, by name; `methods` are
/// from boxFollowerNames(), or empty for all. The checksum covers the boxes that a method finds,
/// with 300 particles, in the first images of the rendered clip (first tuning seed), starting from
/// the true first box.
///
/// Boxes are rounded to 0.01 px. Returns NotFound for an unknown method.
Result<std::map<std::string, std::string>> boxFingerprints(const std::vector<std::string>& methods);

} // namespace dewpoint::experiment
