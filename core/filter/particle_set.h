// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace dewpoint::filter {

/// Writable view of consecutive particles: one row per particle, one contiguous column per
/// coordinate. Each thread works on one such view.
using StateRows = Eigen::Ref<Eigen::ArrayXXd, 0, Eigen::OuterStride<>>;
/// Read-only view of consecutive particles, in the layout of StateRows.
using ConstStateRows = const Eigen::Ref<const Eigen::ArrayXXd, 0, Eigen::OuterStride<>>&;
/// Log weights or log likelihoods of consecutive particles, one per particle.
using LogWeightSegment = Eigen::Ref<Eigen::ArrayXd>;

/// For each particle of the next set, the index of its ancestor in the weighted set. A set has
/// fewer than 2^31 particles.
using Ancestors = std::vector<std::int32_t>;

} // namespace dewpoint::filter
