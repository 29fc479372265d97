// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/proportion.h"

#include <Eigen/Core>

#include <optional>
#include <span>

namespace dewpoint::experiment {

/// What a method states about one target at one frame, and what was true. World frame, m and m².
struct StatedBelief {
  double probability = 0.0; ///< P(exists), in [0, 1]
  bool declared = false;    ///< the method declares the target present
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  std::optional<Eigen::Vector3d> truth; ///< nothing: the target is not there
};

/// A method is sure when it states a greater P(exists) than this.
inline constexpr double kSureProbability = 0.95;
/// How many stated radii off a sure estimate may be. Three: an estimate whose covariance is true is
/// farther off in 0.0006 % (a round ellipsoid) to 0.27 % (one axis dominates) of the frames.
inline constexpr double kSureRadii = 3.0;

/// The distance to the truth that a covariance states as usual: sqrt(trace), the root mean square
/// of the error's length. Meters; NaN when the trace is negative or not a number.
double statedRadius(const Eigen::Matrix3d& covariance);

/// Declared present where the target is not: it is absent, or not nearer than `gate` meters.
bool isWrong(const StatedBelief& belief, double gate);

/// P(exists) above kSureProbability although the target is absent, or farther than kSureRadii
/// stated radii from the stated position. A position or covariance that is not finite is no excuse.
bool isSureAndWrong(const StatedBelief& belief);

/// How often a method is wrong, and how often without any doubt. The total of each is the number of
/// all beliefs, also of those in which the method states nothing.
struct Overconfidence {
  Proportion wrong;         ///< isWrong()
  Proportion wrongWhenSure; ///< isWrong() with P(exists) above kSureProbability
  Proportion sureAndWrong;  ///< isSureAndWrong()
};

Overconfidence overconfidence(std::span<const StatedBelief> beliefs, double gate);

} // namespace dewpoint::experiment
