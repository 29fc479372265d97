// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/ellipsoid_image.h"
#include "core/observation/region/region_measurement.h"
#include "core/observation/region/region_observation.h"
#include "core/tracking/target.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::tracking {

/// Whether a target is taken for a ball or for anything: as it was defined, or by the regions of
/// its color, whose evidence adds up over time.
class ShapeBelief {
public:
  explicit ShapeBelief(const Target& target) { setTarget(target); }

  /// Starts again where shape or radius changed.
  void setTarget(const Target& target);
  void restart();

  bool isBall() const { return !any_; }
  /// Whether the images decide.
  bool isOpen() const { return shape_ == TargetShape::Auto; }
  /// Whether nothing is known of it yet, or the evidence is not clear.
  bool isUnclear() const;
  double logOdds() const { return logOdds_; }

  /// Learns from the regions that show a target of this radius (meters) at this position,
  /// `interval` seconds after the last time. Nothing where no image shows it well enough.
  void learn(const RegionObservation& observation, const std::vector<RegionMeasurement>& views,
             const Eigen::Vector3d& position, double radius, double interval);

private:
  TargetShape shape_ = TargetShape::Auto;
  double radius_ = 0.0;  ///< given; 0: not known
  double logOdds_ = 0.0; ///< of "anything" against "a ball"
  bool any_ = false;
  bool first_ = true;    ///< nothing was learned yet
  double learned_ = 0.0; ///< meters, radius of what was learned from last
};

} // namespace dewpoint::tracking
