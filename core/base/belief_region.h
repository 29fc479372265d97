// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::base {

/// 95 % quantiles of the chi-squared distribution with 2 and 3 degrees of freedom. Each is the
/// squared Mahalanobis distance of the ellipse (2) or ellipsoid (3) that contains 95 % of a normal
/// distribution.
inline constexpr double kChiSquared95TwoDof = 5.991464547107;
inline constexpr double kChiSquared95ThreeDof = 7.814727903251;

} // namespace dewpoint::base
