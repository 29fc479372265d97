// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/camera_overlay.h"
#include "core/session/snapshot/snapshot.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::session {

/// Close-up of a target's particles in parallel projection, for a square picture. Positions are in
/// pixels to the right of and below the center, which is the mean.
struct CloudCloseup {
  double metersPerPixel = 0.0;
  std::vector<Eigen::Vector2f> particles; ///< those in the picture, in order of ascending weight
  std::vector<float> weights;             ///< relative to the largest: 0 to 1
  ImageEllipse outline;   ///< of the ellipsoid that contains the target with a probability of 95 %
  double barMeters = 0.0; ///< length of the scale bar: a round number that fits below the cloud
};

/// Returns the longest semi-axis of the 95 % ellipsoid of the position, in meters. Returns nothing
/// if the position is unknown or there are no particles.
std::optional<double> cloudReach(const TargetSnapshot& target);

/// Returns the close-up seen along the given image axes (unit vectors, world frame). The picture
/// extends `half` pixels from its center. Its scale changes in steps, so that the picture does not
/// zoom with every change of the cloud. It shows at most `most` particles, an even selection.
/// Returns nothing where cloudReach() returns nothing.
std::optional<CloudCloseup> cloudCloseup(const TargetSnapshot& target, const Eigen::Vector3d& right,
                                         const Eigen::Vector3d& up, double half,
                                         Eigen::Index most = 1500);

} // namespace dewpoint::session
