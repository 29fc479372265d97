// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/thread_team.h"
#include "core/filter/moments.h"

#include <Eigen/Core>

namespace dewpoint::filter {

/// Moments of a weighted particle set, in the units of the state.
struct StateEstimate {
  Eigen::VectorXd mean;             ///< weighted mean (MMSE)
  Eigen::MatrixXd covariance;       ///< weighted, about the mean, divisor 1
  Eigen::Index bestIndex = 0;       ///< particle of highest weight (MAP); the first of equals
  double effectiveSampleSize = 0.0; ///< 1 / sum of squared weights
  bool degenerate = false;          ///< no finite log weight: all particles were counted as equal
};

/// The same for a whole set whose moments are known; its weights sum to 1.
StateEstimate estimateFrom(Moments moments);

/// Turns log weights into linear weights that sum to 1, safe from underflow (log-sum-exp). A log
/// weight that is not finite counts as weight zero. Returns false, and makes all weights equal,
/// when no log weight is finite.
bool normalize(const Eigen::ArrayXd& logWeights, Eigen::ArrayXd& weights, ThreadTeam& team);

/// Mean, covariance, best particle and effective sample size for weights that sum to 1. The set
/// must not be empty. Sums run over fixed blocks, put together in particle order, so that their
/// bits depend neither on the number of threads nor on the processor.
StateEstimate estimate(const Eigen::ArrayXXd& states, const Eigen::ArrayXd& weights,
                       ThreadTeam& team);
StateEstimate estimate(const Eigen::ArrayXXd& states, const Eigen::ArrayXd& weights);

} // namespace dewpoint::filter
