// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/gaussian.h"
#include "core/tracking/start_parameters.h"

#include <Eigen/Core>

#include <optional>

namespace dewpoint::tracking {

/// Where a target is expected to appear: in the start volume until it was tracked for the first
/// time, afterwards around its last confirmed position, the less precisely the longer ago that was.
/// World frame, meters.
class SearchPrior {
public:
  /// Forgets the last confirmed position; the target is expected in `start` again.
  void restart(const StartVolume& start);
  /// The position was confirmed in this frame.
  void confirm(const Gaussian3& position);
  /// No position was confirmed for `interval` seconds more: widens the Gaussian around the last one
  /// until its standard deviation is `maxSigma` meters. Does nothing before the first confirm().
  void widen(double interval, double maxSigma);

  /// Probability density (1/m³) with which a target that appears does so at this position: half of
  /// it by this prior, half of it anywhere in a cube with edges of `searchSize` meters; 0 outside
  /// the bounds.
  double birthDensity(const Eigen::Vector3d& position, double searchSize,
                      const std::optional<WorldBox>& bounds = std::nullopt) const;
  /// `count` positions, rows x y z. Position i is drawn from element i of the stream.
  Eigen::ArrayXXd draw(Eigen::Index count, const RandomStream& stream) const;
  /// The last confirmed position; nothing before the first one, or once the standard deviation has
  /// grown beyond 1 m.
  std::optional<Eigen::Vector3d> lastPosition() const;

private:
  StartVolume start_;
  Gaussian3 gaussian_; ///< around the last confirmed position
  bool wasConfirmed_ = false;
};

} // namespace dewpoint::tracking
