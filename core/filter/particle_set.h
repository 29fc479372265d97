// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace dewpoint {

/// Some consecutive particles of a set, writable: one row per particle, one contiguous column per
/// coordinate. What a thread gets to work on.
using StateRows = Eigen::Ref<Eigen::ArrayXXd, 0, Eigen::OuterStride<>>;
using ConstStateRows = const Eigen::Ref<const Eigen::ArrayXXd, 0, Eigen::OuterStride<>>&;
/// The log weights (or log likelihoods) of the same particles.
using LogWeightSegment = Eigen::Ref<Eigen::ArrayXd>;

/// Particles as a structure of arrays.
struct ParticleSet {
  Eigen::ArrayXXd states;    ///< particle count x dimension
  Eigen::ArrayXd logWeights; ///< natural logarithm, up to a common constant

  Eigen::Index particleCount() const { return states.rows(); }
};

} // namespace dewpoint
