// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/proportion.h"

#include <Eigen/Core>

#include <optional>
#include <span>

namespace dewpoint::experiment {

/// What a method reports about one target at one frame, and the truth. World frame, m and m².
struct StatedBelief {
  double probability = 0.0; ///< reported P(exists), in [0, 1]
  bool declared = false;    ///< the method declares the target present
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  std::optional<Eigen::Vector3d> truth; ///< nothing: the target is absent
};

/// Reported P(exists) above which a method counts as sure.
inline constexpr double kSureProbability = 0.95;
/// Largest error of a sure estimate, in reported radii. Chosen as three: if the covariance is
/// right, the error is larger in 0.0006 % (a round ellipsoid) to 0.27 % (one axis dominates) of the
/// frames.
inline constexpr double kSureRadii = 3.0;

/// Typical distance to the truth that a covariance implies: sqrt(trace), the root mean square
/// length of the error. Meters; NaN if the trace is negative or NaN.
double statedRadius(const Eigen::Matrix3d& covariance);

/// Whether the target is declared present where it is not: it is absent, or not nearer than `gate`
/// meters.
bool isWrong(const StatedBelief& belief, double gate);

/// Whether P(exists) is above kSureProbability although the target is absent, or farther than
/// kSureRadii reported radii from the reported position. A position or covariance that is not
/// finite also counts.
bool isSureAndWrong(const StatedBelief& belief);

/// How often a method is wrong, and how often it is wrong while sure. The total of each is the
/// number of all beliefs, including those in which the method reports nothing.
struct Overconfidence {
  Proportion wrong;         ///< isWrong()
  Proportion wrongWhenSure; ///< isWrong() with P(exists) above kSureProbability
  Proportion sureAndWrong;  ///< isSureAndWrong()
};

/// Counts the wrong beliefs; `gate` is in meters.
Overconfidence overconfidence(std::span<const StatedBelief> beliefs, double gate);

} // namespace dewpoint::experiment
