// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "core/session/view/camera_overlay.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::session {

/// Close-up of a target's particles in parallel projection, as a square image. The center of the
/// image is the estimated position. Positions in the image are offsets from its center in pixels: x
/// to the right, y down.
struct CloudCloseup {
  double metersPerPixel = 0.0;
  /// Particles inside the image, in order of ascending weight.
  std::vector<Eigen::Vector2f> particles;
  /// Weights of these particles, relative to the largest weight: 0 to 1.
  std::vector<float> weights;
  /// Outline of the ellipsoid that contains the target with a probability of 95 %.
  ImageEllipse outline;
  /// Length of the scale bar of the image, in meters; a round number.
  double scaleBarMeters = 0.0;
};

/// Returns the longest semi-axis, in meters, of the ellipsoid that contains the target with a
/// probability of 95 %. Returns nothing if the position is unknown or there are no particles.
std::optional<double> cloudSemiAxis(const TargetSnapshot& target);

/// Returns a close-up of the particles of a target. The x axis of the image points along `right`,
/// and `up` points upward in the image (unit vectors, world frame). The image extends `half` pixels
/// from its center in each direction. The scale is chosen so that the particles fill a good part of
/// the image; the outline may lie outside. The scale changes in steps, so that the image does not
/// zoom with every change of the cloud. At most `most` particles are shown, an even selection.
/// Returns nothing if cloudSemiAxis() returns nothing.
std::optional<CloudCloseup> cloudCloseup(const TargetSnapshot& target, const Eigen::Vector3d& right,
                                         const Eigen::Vector3d& up, double half,
                                         Eigen::Index most = 1500);

} // namespace dewpoint::session
