// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace dewpoint::tests {

inline constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

} // namespace dewpoint::tests
