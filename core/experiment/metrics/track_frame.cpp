// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/track_frame.h"

#include <cmath>
#include <limits>

namespace dewpoint::experiment {

Eigen::MatrixXd distances(const TrackFrame& frame) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(frame.truth.size()),
                         static_cast<Eigen::Index>(frame.estimates.size()));
  for (Eigen::Index i = 0; i < result.rows(); ++i) {
    for (Eigen::Index j = 0; j < result.cols(); ++j) {
      const double distance = (frame.truth[static_cast<std::size_t>(i)].position -
                               frame.estimates[static_cast<std::size_t>(j)].position)
                                  .norm();
      result(i, j) = std::isfinite(distance) ? distance : std::numeric_limits<double>::infinity();
    }
  }
  return result;
}

} // namespace dewpoint::experiment
