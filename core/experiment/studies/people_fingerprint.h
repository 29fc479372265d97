// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <map>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Returns a checksum (fingerprint) of the results of each of the methods, by name; `methods` are
/// methods that find people, or empty for all. The checksum covers the results for two people in
/// similar clothes whose paths cross (first tuning seed).
///
/// CLEAR MOT, HOTA, times, and the fractions of found people and of silhouettes are rounded to
/// 0.001, lengths to 0.1 mm, and volumes to 0.0001 m³. Returns NotFound for an unknown method.
Result<std::map<std::string, std::string>>
peopleFingerprints(const std::vector<std::string>& methods);

} // namespace dewpoint::experiment
