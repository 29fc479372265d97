// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>
#include <string_view>

namespace dewpoint::base {

/// Returns an uncertainty with its unit, rounded to two digits and never with an exponent:
/// "+-0.2 degrees", "+-890 px". Returns "unknown" if the value is not finite.
std::string uncertaintyText(double value, std::string_view unit);

/// As above for a length in meters, written in millimeters below one meter: "+-3.1 mm", "+-1.2 m".
std::string lengthUncertaintyText(double meters);

} // namespace dewpoint::base
