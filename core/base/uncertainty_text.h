// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>
#include <string_view>

namespace dewpoint::base {

/// Returns the text of a number, rounded to two significant digits and never with an exponent:
/// "0.000047", "890". Returns "unknown" if the number is not finite.
std::string twoSignificantDigitsText(double value);

/// Returns the text of an uncertainty with its unit, rounded to two significant digits and never
/// with an exponent, for example "+-0.2 degrees" or "+-890 px". Returns "unknown" if the value is
/// not finite.
std::string uncertaintyText(double value, std::string_view unit);

/// Returns the text of the uncertainty of a length, rounded as by uncertaintyText(). The unit is
/// millimeters below one meter and meters otherwise: "+-3.1 mm", "+-1.2 m".
std::string lengthUncertaintyText(double meters);

} // namespace dewpoint::base
