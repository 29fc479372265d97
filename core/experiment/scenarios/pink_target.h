// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/tracker.h"

#include <string>

namespace dewpoint::experiment::scenarios {

/// The target of most scenarios: the pink ball of the paper's kind, with the color range that holds
/// its pixels. `radius` in meters; 0: unknown to the method.
Target pinkTarget(const std::string& name, double radius);

} // namespace dewpoint::experiment::scenarios
