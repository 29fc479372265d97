// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/camera_overlay.h"
#include "core/session/run/snapshot.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::session {

/// The particles of a target enlarged, in parallel projection, for a square picture: pixels right
/// of and below its center, which is the mean.
struct CloudCloseup {
  double metersPerPixel = 0.0;
  std::vector<Eigen::Vector2f> particles; ///< those in the picture, the likeliest last
  std::vector<float> weights;             ///< relative to the largest: 0 to 1
  ImageEllipse outline;                   ///< of the ellipsoid that holds 95 % of the belief
  double barMeters = 0.0;                 ///< a round length that fits below the cloud
};

/// From the mean to the rim of the ellipsoid that holds 95 % of the belief, along its longest axis,
/// meters; nothing where the position is not known or no particle tells of it.
std::optional<double> cloudReach(const TargetSnapshot& target);

/// As seen by an eye with these axes (world, unit). The picture reaches `half` pixels from its
/// center. Its scale takes steps, so that it does not breathe with the cloud. At most
/// `most` particles, evenly chosen. Nothing where cloudReach() is nothing.
std::optional<CloudCloseup> cloudCloseup(const TargetSnapshot& target, const Eigen::Vector3d& right,
                                         const Eigen::Vector3d& up, double half,
                                         Eigen::Index most = 1500);

} // namespace dewpoint::session
