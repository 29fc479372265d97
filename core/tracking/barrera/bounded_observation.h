// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/models.h"
#include "core/geometry/world_box.h"

#include <Eigen/Core>

#include <limits>

namespace dewpoint::tracking {

/// Observation model that equals `observation` inside `bounds` and has zero likelihood outside. In
/// a state, columns 0 to 2 are x, y, z in meters, world frame. The observation and the bounds must
/// outlive this object.
template <ObservationModel O> struct BoundedObservation {
  const O& observation;
  const WorldBox& bounds;

  void addLogLikelihood(ConstStateRows rows, LogWeightSegment logLikelihood) const {
    observation.addLogLikelihood(rows, logLikelihood);
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      if (!bounds.contains({rows(i, 0), rows(i, 1), rows(i, 2)})) {
        logLikelihood[i] = -std::numeric_limits<double>::infinity();
      }
    }
  }
};

} // namespace dewpoint::tracking
