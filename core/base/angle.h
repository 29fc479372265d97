// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <numbers>

namespace dewpoint::base {

/// One degree in radians.
inline constexpr double kDegree = std::numbers::pi / 180.0;

} // namespace dewpoint::base
