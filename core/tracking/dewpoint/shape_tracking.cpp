// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/shape_tracking.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::tracking {
namespace {

// Judgments (docs/method-dewpoint.md, section 12).

/// Frames from one measurement of a target that was found as a ball to the next.
constexpr std::int64_t kMeasurementPeriod = 8;
/// Frames after a restart in which one whose shape is unclear is measured each time. Later it may
/// stay unclear, beside something of its color, and fewer measurements say as much: each counts by
/// the time since the one before.
constexpr std::int64_t kFirstFrames = 30;

/// Radius (meters) of a ball whose outlines have second moments as large as those of the regions
/// that were found where one of `radius` was expected.
double radiusOf(const std::vector<RegionMeasurement>& views, double radius) {
  double sum = 0.0;
  int count = 0;
  for (const RegionMeasurement& view : views) {
    if (view.region) {
      sum += 0.5 *
             std::log(4.0 * view.region->covariance.trace() / view.expectedOutline.extent.trace());
      ++count;
    }
  }
  return count > 0 ? radius * std::exp(sum / count) : radius;
}

} // namespace

void ShapeTracking::setTarget(const Target& target) {
  const bool wasBall = belief_.isBall();
  belief_.setTarget(target);
  track_.setTarget(target);
  if (belief_.isBall() && !wasBall) {
    track_.discardHypothesis();
  }
}

void ShapeTracking::restart(const StartVolume& start) {
  belief_.restart();
  track_.restart(start);
  sinceLearned_ = 0.0;
  frames_ = 0;
}

void ShapeTracking::predict(double interval, const RandomKey& key) {
  ++frames_;
  sinceLearned_ += interval;
  track_.predict(interval, key);
}

bool ShapeTracking::needsImages(bool ballFound) const {
  const bool isNew = belief_.isUnclear() && frames_ <= kFirstFrames;
  return belief_.isDecidedByImages() && (!ballFound || isNew || frames_ % kMeasurementPeriod == 0);
}

void ShapeTracking::learn(const std::vector<RegionMeasurement>& views,
                          const Eigen::Vector3d& position, double radius) {
  belief_.learn(observation_, views, position, radius, sinceLearned_);
  sinceLearned_ = 0.0;
}

void ShapeTracking::measureBall(const TrackHypothesis& ball, const RandomKey& key,
                                ThreadTeam& team) {
  track_.discardHypothesis();
  std::vector<RegionMeasurement> views(observation_.cameraCount());
  for (std::size_t k = 0; k < views.size(); ++k) {
    auto& view = observation_.views()[k];
    const auto outline = view.projector.project(
        {ball.position() + view.timeOffset * ball.velocity(), ballExtent(ball.radius)});
    if (!view.labels.empty() && outline) {
      views[k] = measureRegion(view.labels, *outline, Eigen::Matrix2d::Zero());
    }
  }
  learn(views, ball.position(), ball.radius);
  if (!belief_.isBall()) {
    const double radius = radiusOf(views, ball.radius);
    track_.startAt({ball.position(), ballExtent(radius)}, ballExtent(radius), false, observation_,
                   key, team);
  }
}

void ShapeTracking::update(const std::vector<OccupiedSphere>& occupied, const RandomKey& key,
                           ThreadTeam& team) {
  track_.update(observation_, occupied, key, team);
  const TrackHypothesis* const found = track_.hypothesis();
  if (found != nullptr && found->probability > 0.5 && found->wasOutlineFound) {
    learn(track_.measurements(), found->position(), found->radius);
  }
}

void ShapeTracking::correct(const Gaussian3& position, double radius, const RandomKey& key,
                            ThreadTeam& team) {
  const Eigen::Matrix3d extent =
      track_.hypothesis() != nullptr ? track_.extent() : ballExtent(radius);
  track_.startAt(position, extent, true, observation_, key, team);
}

} // namespace dewpoint::tracking
