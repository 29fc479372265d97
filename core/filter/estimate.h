// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/thread_team.h"
#include "core/filter/moments.h"

#include <Eigen/Core>

namespace dewpoint::filter {

/// Mean, covariance and other statistics of a weighted particle set, in the units of the state.
struct StateEstimate {
  Eigen::VectorXd mean;       ///< weighted mean (MMSE)
  Eigen::MatrixXd covariance; ///< weighted covariance about the mean, without bias correction
  /// Index of the particle with the highest weight (MAP); the first such particle if there are
  /// ties.
  Eigen::Index bestIndex = 0;
  double effectiveSampleSize = 0.0; ///< 1 / sum of squared weights
  /// True if no log weight was finite, so that all particles were weighted equally.
  bool isDegenerate = false;
};

/// Computes the estimate for a whole set from its `Moments`. The weights of the set must sum to 1.
StateEstimate estimateFrom(Moments moments);

/// Converts log weights to linear weights that sum to 1, without underflow (log-sum-exp). A log
/// weight that is not finite becomes weight zero. If no log weight is finite, the function makes
/// all weights equal and returns false.
bool normalize(const Eigen::ArrayXd& logWeights, Eigen::ArrayXd& weights, ThreadTeam& team);

/// Returns mean, covariance, best particle and effective sample size. The weights must sum to 1,
/// and the set must not be empty. Sums are taken over fixed blocks and combined in particle order,
/// so the results are bit-identical for any number of threads and on any processor.
StateEstimate estimate(const Eigen::ArrayXXd& states, const Eigen::ArrayXd& weights,
                       ThreadTeam& team);
StateEstimate estimate(const Eigen::ArrayXXd& states, const Eigen::ArrayXd& weights);

} // namespace dewpoint::filter
