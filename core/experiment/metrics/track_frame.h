// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace dewpoint::experiment {

/// True or estimated position of one target in one frame. World frame, meters.
struct TrackPoint {
  int identity = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// Input of the multi-target metrics for one frame: the targets that are present, and those that
/// the method declares present. Identities are unique within `truth` and within `estimates`; the
/// two sets of identities are unrelated. An estimate whose position is not finite matches no true
/// target but still counts as declared.
struct TrackFrame {
  std::int64_t frame = 0;
  double time = 0.0; ///< time of the frame, seconds
  std::vector<TrackPoint> truth;
  std::vector<TrackPoint> estimates;
};

/// Returns the distances between true targets (rows) and estimates (columns), meters. A distance is
/// infinite if either position is not finite.
Eigen::MatrixXd distances(const TrackFrame& frame);

} // namespace dewpoint::experiment
