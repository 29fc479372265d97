// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/draft/target_truth.h"

#include "core/simulation/body/target_volume.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>

namespace dewpoint::experiment::scenarios {

TargetTruth targetTruth(const simulation::StageBody& body, double time) {
  const Eigen::Vector3d center = body.path(time);
  const TargetTruth ball{center, {body.radius, Eigen::Vector3d::Constant(body.radius)}};
  const simulation::TargetVolume filled = simulation::targetVolume(body.partsAt(time));
  if (filled.volume == 0.0) {
    return ball;
  }
  // A solid ellipsoid's variance along an axis is a fifth of its squared semi-axis.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(filled.covariance,
                                                            Eigen::EigenvaluesOnly);
  const Eigen::Vector3d variances = axes.eigenvalues().reverse().cwiseMax(0.0);
  return {center + filled.centroid,
          {std::cbrt(0.75 / std::numbers::pi * filled.volume), (5.0 * variances).cwiseSqrt()}};
}

} // namespace dewpoint::experiment::scenarios
