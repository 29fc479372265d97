// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/shape_belief.h"

#include "core/observation/region/roundness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::tracking {
namespace {

// Judgments (docs/method-dewpoint.md, section 12).

/// Log odds of "anything" before any image: somebody who gives a radius means a ball.
constexpr double kPriorOfUnknown = -4.0;
constexpr double kPriorOfGiven = -30.0;
/// Log odds at most, either way, so that a belief can change within seconds. What is known of a
/// given radius stays known.
constexpr double kMost = 15.0;
/// Log odds beyond zero at which the belief changes.
constexpr double kHysteresis = 2.0;
/// Evidence of one set of images at most, either way.
constexpr double kMostAtOnce = 5.0;
/// Seconds between two images of a target that tell it anew.
constexpr double kIndependent = 0.5;
/// Factor of the radius, either way, beyond which a ball that was found is another one than before:
/// its images tell anew at once.
constexpr double kAnotherSize = 1.5;
/// Factor of a given radius, either way, beyond which what is seen is not the target alone: two
/// balls that touch are 1.41 times as large.
constexpr double kMostSize = 1.35;

/// Logarithm of the ratio of the size that a region shows to a radius at its place.
double logSize(const ColorRegion& region, const EllipseImage& ball) {
  return 0.5 * std::log(region.area / ball.area());
}

} // namespace

void ShapeBelief::setTarget(const Target& target) {
  const bool changed = target.shape != shape_ || target.radius != radius_;
  shape_ = target.shape;
  radius_ = target.radius;
  if (changed || first_) {
    restart();
  }
}

void ShapeBelief::restart() {
  logOdds_ = radius_ > 0.0 ? kPriorOfGiven : kPriorOfUnknown;
  any_ = shape_ == TargetShape::Any;
  first_ = true;
}

bool ShapeBelief::isUnclear() const {
  return isDecidedByImages() && (first_ || std::abs(logOdds_) < kMost - kMostAtOnce);
}

void ShapeBelief::learn(const RegionObservation& observation,
                        const std::vector<RegionMeasurement>& views,
                        const Eigen::Vector3d& position, double radius, double interval) {
  double sum = 0.0;
  bool any = false;
  for (std::size_t k = 0; k < views.size(); ++k) {
    const double size = radius_ > 0.0 ? radius_ : radius;
    const auto ball = observation.views()[k].projector.project(
        {position, size * size * Eigen::Matrix3d::Identity()});
    if (!views[k].region || !ball) {
      continue;
    }
    if (radius_ > 0.0 && std::abs(logSize(*views[k].region, *ball)) > std::log(kMostSize)) {
      continue;
    }
    if (const auto evidence = shapeEvidence(*views[k].region, *ball)) {
      sum += *evidence;
      any = true;
    }
  }
  if (!isDecidedByImages() || !any) {
    return;
  }
  const bool isAnother =
      first_ || (radius_ == 0.0 && std::abs(std::log(radius / learned_)) > std::log(kAnotherSize));
  const double weight = isAnother ? 1.0 : std::min(1.0, interval / kIndependent);
  first_ = false;
  learned_ = radius;
  const double least = std::min(-kMost, radius_ > 0.0 ? kPriorOfGiven : kPriorOfUnknown);
  logOdds_ =
      std::clamp(logOdds_ + weight * std::clamp(sum, -kMostAtOnce, kMostAtOnce), least, kMost);
  if (logOdds_ > kHysteresis) {
    any_ = true;
  } else if (logOdds_ < -kHysteresis) {
    any_ = false;
  }
}

} // namespace dewpoint::tracking
