// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::base {

/// 95 % quantiles of the chi-squared distribution with 2 and 3 degrees of freedom. With 2 degrees
/// of freedom, this is the squared Mahalanobis distance of the points on the ellipse that contains
/// 95 % of a normal distribution. With 3, it is that of the points on the ellipsoid.
inline constexpr double kChiSquared95TwoDof = 5.991464547107;
inline constexpr double kChiSquared95ThreeDof = 7.814727903251;

} // namespace dewpoint::base
