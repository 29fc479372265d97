// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace dewpoint::filter {

/// Some consecutive particles of a set, writable: one row per particle, one contiguous column per
/// coordinate. What a thread gets to work on.
using StateRows = Eigen::Ref<Eigen::ArrayXXd, 0, Eigen::OuterStride<>>;
using ConstStateRows = const Eigen::Ref<const Eigen::ArrayXXd, 0, Eigen::OuterStride<>>&;
/// The log weights (or log likelihoods) of the same particles.
using LogWeightSegment = Eigen::Ref<Eigen::ArrayXd>;

/// Which particle of a weighted set each particle of the next one comes from. A set has fewer than
/// 2^31.
using Ancestors = std::vector<std::int32_t>;

} // namespace dewpoint::filter
