// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/tracker.h"

#include <string>

namespace dewpoint::experiment::scenarios {

/// Target of most scenarios: a pink ball like the paper's, with the color range that contains its
/// pixels. `radius` is in meters; 0: the method does not know it.
Target pinkTarget(const std::string& name, double radius);

} // namespace dewpoint::experiment::scenarios
