// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <map>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// As suiteFingerprints(), of methods that find people: what comes out of two people in similar
/// clothes who cross (the first tuning seed). All methods for none.
///
/// Rounded: CLEAR MOT, HOTA, times, and shares of those found and of silhouettes to 0.001, meters
/// to 0.1 mm, volumes to 0.0001 m³. NotFound for a method that does not exist.
Result<std::map<std::string, std::string>>
peopleFingerprints(const std::vector<std::string>& methods);

} // namespace dewpoint::experiment
