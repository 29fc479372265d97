// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/models.h"

#include <Eigen/Core>

#include <optional>

namespace dewpoint::observation {

/// Likelihood of positions x y z (meters) given a measured position: an isotropic Gaussian around
/// the measured position (Barrera et al. 2005, section III-C; the paper does not specify sigma).
/// Only the logarithm of the likelihood is computed, because the likelihood can be extremely small:
/// exp(-200) at a distance of 2 m with a sigma of 0.1 m. Without a measurement, every position is
/// equally likely.
struct PositionLikelihood {
  std::optional<Eigen::Vector3d> measuredPosition;
  /// Standard deviation of the Gaussian along each axis, meters.
  double sigma = 0.1;

  /// Adds the log likelihood of each state, except for a constant term, to `logLikelihood`.
  void addLogLikelihood(ConstStateRows rows, LogWeightSegment logLikelihood) const {
    if (!measuredPosition) {
      return;
    }
    const double factor = -0.5 / (sigma * sigma);
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      const double x = rows(i, 0) - measuredPosition->x();
      const double y = rows(i, 1) - measuredPosition->y();
      const double z = rows(i, 2) - measuredPosition->z();
      logLikelihood[i] += factor * (x * x + y * y + z * z);
    }
  }
};

} // namespace dewpoint::observation
