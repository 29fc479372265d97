// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/ellipsoid_image.h"
#include "core/observation/region/region_measurement.h"
#include "core/observation/region/region_observation.h"
#include "core/tracking/target.h"

#include <Eigen/Core>

#include <vector>

namespace dewpoint::tracking {

/// Belief about whether a target is a ball. If the target's definition leaves the shape open, the
/// belief is learned from the regions of the target's color in the images. Each region gives log
/// odds, which are added up over time.
class ShapeBelief {
public:
  explicit ShapeBelief(const Target& target) { setTarget(target); }

  /// Sets the target. Learning starts from scratch if the shape or radius of the target has
  /// changed.
  void setTarget(const Target& target);
  void restart();

  bool isBall() const { return !any_; }
  /// Returns whether the images decide the shape, because the target's definition leaves it open.
  bool isDecidedByImages() const { return shape_ == TargetShape::Auto; }
  /// Returns whether nothing has been learned yet, or the log odds are too small to decide.
  bool isUnclear() const;
  /// Returns the log odds (natural logarithm) of "the target has any shape" against "the target is
  /// a ball".
  double logOdds() const { return logOdds_; }

  /// Learns from the regions that show a target of this radius (meters) at this position,
  /// `interval` seconds after the last call. Does nothing if no image shows the target well enough.
  void learn(const RegionObservation& observation, const std::vector<RegionMeasurement>& views,
             const Eigen::Vector3d& position, double radius, double interval);

private:
  TargetShape shape_ = TargetShape::Auto;
  double radius_ = 0.0;  ///< given radius, meters; 0: unknown
  double logOdds_ = 0.0; ///< log odds of any shape relative to a ball, nats
  bool any_ = false;
  bool first_ = true;    ///< nothing has been learned yet
  double learned_ = 0.0; ///< radius in the last learning step, meters
};

} // namespace dewpoint::tracking
