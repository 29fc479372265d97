// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace dewpoint::experiment {

/// Target, or an estimate of one, at one instant. World frame, meters.
struct TrackPoint {
  int identity = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// Input of the metrics of several targets at one instant: the targets that are present, and those
/// that the method declares present. Identities do not repeat within `truth`, nor within
/// `estimates`; the two sets of identities are unrelated. An estimate whose position is not finite
/// matches no truth but still counts as declared.
struct TrackFrame {
  std::int64_t frame = 0;
  double time = 0.0; ///< seconds
  std::vector<TrackPoint> truth;
  std::vector<TrackPoint> estimates;
};

/// Distances in meters, one row per truth and one column per estimate; infinite if either is not
/// finite.
Eigen::MatrixXd distances(const TrackFrame& frame);

} // namespace dewpoint::experiment
