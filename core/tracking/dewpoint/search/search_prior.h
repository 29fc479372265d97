// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/gaussian.h"
#include "core/tracking/start_parameters.h"

#include <Eigen/Core>

#include <optional>

namespace dewpoint::tracking {

/// Prior for the position at which a target appears. Until the target is tracked for the first
/// time, the prior is the start volume. Afterward, it is a Gaussian around the last confirmed
/// position, which widens with time. World frame, meters.
class SearchPrior {
public:
  /// Discards the last confirmed position; the target is expected in `start` again.
  void restart(const StartVolume& start);
  /// Sets the position confirmed in this frame.
  void confirmPosition(const Gaussian3& position);
  /// Widens the Gaussian after another `interval` seconds without a confirmed position, up to a
  /// standard deviation of `maxSigma` meters. Does nothing before the first confirmPosition().
  void widen(double interval, double maxSigma);

  /// Returns the probability density (1/m³) that a target appears at `position`. Half of the
  /// density comes from this prior, and half is uniform in a cube with edges of `searchCubeEdge`
  /// meters. The density is 0 outside the bounds.
  double birthDensity(const Eigen::Vector3d& position, double searchCubeEdge,
                      const std::optional<WorldBox>& bounds = std::nullopt) const;
  /// Draws `count` positions from the prior: rows of x, y, z. Position i is drawn from element i of
  /// the stream.
  Eigen::ArrayXXd drawPositions(Eigen::Index count, const RandomStream& stream) const;
  /// Returns the last confirmed position. Returns nothing before the first confirmPosition(), or
  /// after the standard deviation has grown beyond 1 m.
  std::optional<Eigen::Vector3d> lastPosition() const;

private:
  StartVolume start_;
  Gaussian3 gaussian_; ///< around the last confirmed position
  bool wasConfirmed_ = false;
};

} // namespace dewpoint::tracking
