// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <numbers>

namespace dewpoint::base {

/// Radians in a degree.
inline constexpr double kDegree = std::numbers::pi / 180.0;

} // namespace dewpoint::base
