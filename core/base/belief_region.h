// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::base {

/// 95 % quantile of the chi-squared distribution with 2 degrees of freedom: the squared Mahalanobis
/// distance of the points on the ellipse that contains 95 % of a 2D normal distribution.
inline constexpr double kChiSquared95TwoDof = 5.991464547107;
/// 95 % quantile of the chi-squared distribution with 3 degrees of freedom: the squared Mahalanobis
/// distance of the points on the ellipsoid that contains 95 % of a 3D normal distribution.
inline constexpr double kChiSquared95ThreeDof = 7.814727903251;

} // namespace dewpoint::base
