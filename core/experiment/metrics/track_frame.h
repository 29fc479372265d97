// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace dewpoint::experiment {

/// A target, or an estimate of one, at one instant. World frame, meters.
struct TrackPoint {
  int identity = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// What the metrics of several targets compare at one instant: who was there, and whom the method
/// declared present. Identities do not repeat within `truth`, nor within `estimates`; the two sets
/// of identities have nothing to do with each other. An estimate whose position is not finite is
/// near nothing: it leaves its truth missed and counts as declared.
struct TrackFrame {
  std::int64_t frame = 0;
  double time = 0.0; ///< seconds
  std::vector<TrackPoint> truth;
  std::vector<TrackPoint> estimates;
};

/// Distances in meters, one row per truth and one column per estimate; infinite where either is not
/// finite.
Eigen::MatrixXd distances(const TrackFrame& frame);

} // namespace dewpoint::experiment
