// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/proportion.h"

#include <Eigen/Core>

#include <optional>
#include <span>

namespace dewpoint::experiment {

/// What a method reports about one target in one frame, and the truth. World frame; position in m,
/// covariance in m².
struct ReportedBelief {
  double probability = 0.0; ///< reported P(exists), in [0, 1]
  bool isDeclared = false;  ///< true if the method declares the target present
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  std::optional<Eigen::Vector3d> truth; ///< true position; empty: the target is absent
};

/// Reported existence probability P(exists) above which a method counts as confident.
inline constexpr double kConfidentProbability = 0.95;
/// Largest acceptable error of a confident estimate, as a multiple of reportedRadius(). Three was
/// chosen because, with a correct covariance, the error exceeds this limit in few frames: from
/// 0.0006 % of the frames for a round ellipsoid to 0.27 % for an ellipsoid with one dominant axis.
inline constexpr double kConfidentRadii = 3.0;

/// Returns the typical distance to the truth that a covariance (m²) implies, in meters: the root
/// mean square length of the error, which is sqrt(trace). Returns NaN if the trace is negative or
/// NaN.
double reportedRadius(const Eigen::Matrix3d& covariance);

/// Returns whether the method is wrong: it declares the target present although the target is
/// absent, or is at least `gate` meters from the reported position.
bool isWrong(const ReportedBelief& belief, double gate);

/// Returns whether the method is confidently wrong: P(exists) is above kConfidentProbability
/// although the target is absent, or farther than kConfidentRadii reported radii from the reported
/// position. A position or covariance that is not finite also counts as wrong.
bool isConfidentlyWrong(const ReportedBelief& belief);

/// Numbers of cases in which a method is wrong, out of all beliefs, including those in which the
/// method reports nothing.
struct Overconfidence {
  Proportion wrongShare; ///< cases in which the reported presence or position is wrong (isWrong())
  /// Cases in which the reported presence or position is wrong (isWrong()) and P(exists) is above
  /// kConfidentProbability.
  Proportion wrongAndConfidentShare;
  /// Cases in which the method is confidently wrong (isConfidentlyWrong()).
  Proportion confidentlyWrongShare;
};

/// Counts the beliefs in which a method is wrong (isWrong()) or confidently wrong; `gate` is in
/// meters.
Overconfidence measureOverconfidence(std::span<const ReportedBelief> beliefs, double gate);

} // namespace dewpoint::experiment
