// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/tracker.h"

#include <string>

namespace dewpoint::experiment::scenarios {

/// Returns the target of most scenarios: a pink ball like the one in the paper, with the color
/// range that contains its pixels. `radius` is in meters, or 0 if the method does not know it.
Target pinkTarget(const std::string& name, double radius);

} // namespace dewpoint::experiment::scenarios
