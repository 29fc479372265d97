// SPDX-License-Identifier: GPL-3.0-or-later
// How the colors of a DewpointTracker's targets follow slow changes of light.
#include "core/tracking/dewpoint/dewpoint_tracker.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::tracking {
namespace {

constexpr double kMinExistence = 0.95;
constexpr double kMaxSpreadRadii =
    0.5; ///< of the particles, in radii: the outline is where it is said
constexpr double kMinEffectiveShare = 0.1; ///< effective sample size, as a share of the particles
constexpr double kMinRadiusPx = 3.0;       ///< radius in pixels: less is mostly rim
constexpr double kMinSeparation = 1.2; ///< radii between outlines that do not blur into each other

bool liesWithin(const SphereImage& outline, const cv::Size& size) {
  const Eigen::Array2d corner(size.width - 1, size.height - 1);
  return (outline.center.array() >= outline.radius).all() &&
         (outline.center.array() <= corner - outline.radius).all();
}

} // namespace

bool DewpointTracker::isSurelyThere(std::size_t target) const {
  const SphereEstimate& estimate = estimates_[target];
  const TrackHypothesis* best = tracked_[target].belief.best();
  return best != nullptr && best->isSaturated() && estimate.valid && !estimate.degenerate &&
         estimate.existence >= kMinExistence &&
         estimate.spread() <= kMaxSpreadRadii * estimate.radius &&
         estimate.effectiveSampleSize >= kMinEffectiveShare * estimate.particleCount;
}

std::vector<SphereImage> DewpointTracker::outlinesOfOthers(std::size_t target, std::size_t camera,
                                                           bool sameColor) const {
  const Tracked& own = tracked_[target];
  std::vector<SphereImage> outlines;
  for (std::size_t k = 0; k < tracked_.size(); ++k) {
    const TrackHypothesis* other = k != target ? tracked_[k].belief.confident() : nullptr;
    if (other == nullptr ||
        (sameColor && !(tracked_[k].belief.target().color == own.belief.target().color))) {
      continue;
    }
    if (const auto outline =
            own.observation.projector(camera).project(other->position(), other->radius)) {
      outlines.push_back(*outline);
    }
  }
  return outlines;
}

bool DewpointTracker::showsWhole(std::size_t target, std::size_t camera,
                                 const SphereImage& outline) const {
  const auto& cameras = estimates_[target].cameras;
  if (camera >= cameras.size() || !cameras[camera].inView ||
      cameras[camera].visible < kWholeShare || outline.radius < kMinRadiusPx ||
      !liesWithin(outline, frameOf(camera)->image.size())) {
    return false;
  }
  const auto others = outlinesOfOthers(target, camera, false);
  return std::ranges::none_of(others, [&](const SphereImage& other) {
    return (other.center - outline.center).norm() <
           kMinSeparation * (other.radius + outline.radius);
  });
}

void DewpointTracker::followColor(std::size_t target, double share) {
  Tracked& own = tracked_[target];
  const Eigen::Vector3d velocity = own.belief.best()->velocity();
  for (std::size_t camera = 0; camera < rig_.size(); ++camera) {
    const FramePtr frame = frameOf(camera);
    if (!frame) {
      continue;
    }
    const Eigen::Vector3d place = estimates_[target].mean + timeOffsetOf(camera) * velocity;
    const auto outline =
        own.observation.projector(camera).project(place, estimates_[target].radius);
    if (outline && showsWhole(target, camera, *outline)) {
      own.color.follow(camera, frame->image, *outline, outlinesOfOthers(target, camera, true),
                       share);
    }
  }
}

void DewpointTracker::followColors() {
  const double timeConstant = parameters_.at("color_adaptation");
  if (timeConstant <= 0.0) {
    return;
  }
  const double share = -std::expm1(-secondsSinceLastFrame() / timeConstant);
  for (std::size_t k = 0; k < targetCount_; ++k) {
    if (isSurelyThere(k)) {
      followColor(k, share);
    }
  }
  // What looks like a target does so in this light as well.
  for (std::size_t k = targetCount_; k < tracked_.size(); ++k) {
    const auto same =
        std::find_if(tracked_.begin(), tracked_.begin() + static_cast<std::ptrdiff_t>(targetCount_),
                     [&](const Tracked& target) {
                       return target.belief.target().color == tracked_[k].belief.target().color;
                     });
    if (same != tracked_.begin() + static_cast<std::ptrdiff_t>(targetCount_)) {
      tracked_[k].color = same->color;
    }
  }
}

} // namespace dewpoint::tracking
