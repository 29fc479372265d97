// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_motion/agreement/sighting_history.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::camera_motion {
namespace {

// Chosen on tuning seeds of the suite's scenarios.
constexpr double kLongestGap = 0.15; ///< seconds between images in which a region is followed
constexpr double kGateRadii = 2.0;   ///< from where it is expected
constexpr double kLeastGate = 8.0;   ///< pixels
constexpr double kSameSize = 1.8;    ///< ratio of radii in successive images
constexpr double kCountsAfter = 1.0; ///< radii
constexpr double kLeastMoved = 6.0;  ///< pixels: more than noise moves a small region

} // namespace

SightingHistory::SightingHistory(const ColorRanges& color, const Camera& camera)
    : search_(color), unprojector_(geometry::withoutPose(camera)) {}

std::size_t SightingHistory::countEvidence() const {
  std::size_t count = 0;
  for (const SightingImage& image : images_) {
    count += static_cast<std::size_t>(
        std::ranges::count(image.regions, true, &RegionSighting::countsAsEvidence));
  }
  return count;
}

void SightingHistory::add(const cv::Mat& image, double time) {
  if (!images_.empty() && time <= images_.back().captureTime) {
    return;
  }
  SightingImage now{time, {}};
  for (const ColorRegion& region : search_.find(image)) {
    if (const auto direction = unprojector_.worldDirection(region.center)) {
      now.regions.push_back({.region = region, .direction = *direction});
    }
  }
  if (!images_.empty() && time - images_.back().captureTime <= kLongestGap) {
    trackRegions(images_.back(), now);
  }
  std::vector<CountedPosition> counted;
  for (RegionSighting& sighting : now.regions) {
    const auto& center = sighting.region.center;
    const auto last = std::ranges::find(counted_, sighting.track, &CountedPosition::track);
    if (sighting.track == 0 || last == counted_.end()) {
      sighting.track = ++tracks_;
      counted.push_back({sighting.track, center});
      continue;
    }
    sighting.countsAsEvidence = (center - last->center).norm() >=
                                std::max(kLeastMoved, kCountsAfter * sighting.region.radius);
    counted.push_back({sighting.track, sighting.countsAsEvidence ? center : last->center});
  }
  counted_ = std::move(counted);
  images_.push_back(std::move(now));
  while (images_.front().captureTime < time - kHistorySeconds) {
    images_.pop_front();
  }
}

void SightingHistory::trackRegions(const SightingImage& before, SightingImage& now) {
  const double passed = now.captureTime - before.captureTime;
  std::vector<bool> taken(now.regions.size(), false);
  for (const RegionSighting& old : before.regions) { // the largest first
    const Eigen::Vector2d expected = old.region.center + passed * old.rate;
    double nearest = std::max(kLeastGate, kGateRadii * old.region.radius);
    std::size_t best = now.regions.size();
    for (std::size_t i = 0; i < now.regions.size(); ++i) {
      const ColorRegion& region = now.regions[i].region;
      const double ratio = region.radius / old.region.radius;
      const double off = (region.center - expected).norm();
      if (!taken[i] && ratio < kSameSize && ratio * kSameSize > 1.0 && off < nearest) {
        nearest = off;
        best = i;
      }
    }
    if (best < now.regions.size()) {
      taken[best] = true;
      now.regions[best].track = old.track;
      RegionSighting& next = now.regions[best];
      next.rate = (next.region.center - old.region.center) / passed;
      next.directionRate = (next.direction - old.direction) / passed;
    }
  }
  // What comes after an image tells its rates better.
  for (RegionSighting& old : images_.back().regions) {
    const auto next = std::ranges::find(now.regions, old.track, &RegionSighting::track);
    if (next != now.regions.end()) {
      const double share = old.rate.isZero() ? 1.0 : 0.5; // of what comes
      old.rate += share * (next->rate - old.rate);
      old.directionRate += share * (next->directionRate - old.directionRate);
    }
  }
}

} // namespace dewpoint::camera_motion
