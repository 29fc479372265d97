// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/search/region_search.h"

#include "core/observation/region/color_region.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::tracking {
namespace {

// Judgments (docs/method-dewpoint.md, section 12).

constexpr std::size_t kMostRegions = 16; ///< per camera, the largest
constexpr double kLeastArea = 12.0;      ///< pixels
/// Pixels, and radii of a region, that its ray may miss the object's center by at most: two
/// standard deviations.
constexpr double kMissPx = 4.0;
constexpr double kMissRadii = 0.5;
/// Standard deviation of the logarithm of the size that a region shows: a stick is thin from its
/// end. And from which deviation on two regions are not of one object.
constexpr double kSearchSizeSigma = 0.5;
constexpr double kMostSearchSize = 1.4;
/// Squared standard deviations for each camera that has the position in its image, but no region.
constexpr double kMissing = 4.0;

struct Seen {
  Ray ray;
  double focal = 1.0;
  double radiusPx = 0.0;
  double area = 0.0;
};

double missPx(const Seen& seen, const Eigen::Vector3d& point) {
  const double depth = std::max(1e-9, (point - seen.ray.origin).norm());
  return seen.focal * distanceToRay(seen.ray, point) / depth;
}

double logRadius(const Seen& seen, const Eigen::Vector3d& point) {
  return std::log(seen.radiusPx * (point - seen.ray.origin).norm() / seen.focal);
}

/// Squared deviation of the ray; more than 4: not of one object.
double rayCost(const Seen& seen, const Eigen::Vector3d& point) {
  const double share = missPx(seen, point) / std::max(kMissPx, kMissRadii * seen.radiusPx);
  return 4.0 * share * share;
}

std::optional<RegionCandidate> candidateOf(const std::vector<const Seen*>& members, double radius) {
  std::vector<Ray> rays;
  rays.reserve(members.size());
  for (const Seen* seen : members) {
    rays.push_back(seen->ray);
  }
  const auto point = nearestPoint(rays);
  if (!point) {
    return std::nullopt;
  }
  RegionCandidate result;
  result.center = *point;
  double mean = 0.0;
  double smallest = members.front()->area;
  for (const Seen* seen : members) {
    mean += logRadius(*seen, *point) / static_cast<double>(members.size());
    smallest = std::min(smallest, seen->area);
  }
  // A large region says nothing for a speck that it is paired with.
  result.logRarity = static_cast<double>(members.size()) * std::log(smallest / kLeastArea);
  result.radius = std::exp(mean);
  const double expected = radius > 0.0 ? std::log(radius) : mean;
  for (const Seen* seen : members) {
    const double ray = rayCost(*seen, *point);
    const double size = logRadius(*seen, *point) - expected;
    if (ray > 4.0 || std::abs(size) > kMostSearchSize) {
      return std::nullopt;
    }
    result.misfit += ray + size * size / (kSearchSizeSigma * kSearchSizeSigma);
  }
  return result;
}

bool isInView(const RegionObservation::View& view, const Eigen::Vector3d& point) {
  const auto pixel = view.projector.projector().project(point);
  return !view.labels.empty() && pixel && pixel->x() >= 0.0 && pixel->y() >= 0.0 &&
         pixel->x() <= view.labels.size().width - 1 && pixel->y() <= view.labels.size().height - 1;
}

std::vector<std::vector<Seen>> regionsOf(RegionObservation& observation) {
  std::vector<std::vector<Seen>> all(observation.cameraCount());
  for (std::size_t k = 0; k < all.size(); ++k) {
    auto& view = observation.views()[k];
    if (view.labels.empty()) {
      continue;
    }
    const cv::Rect whole(cv::Point(0, 0), view.labels.size());
    for (const ColorRegion& region : findRegions(view.labels, whole, kLeastArea)) {
      const auto ray = view.unprojector.ray(region.centroid);
      if (ray && all[k].size() < kMostRegions) {
        all[k].push_back({*ray, view.projector.focalLength(),
                          std::sqrt(region.area / std::numbers::pi), region.area});
      }
    }
  }
  return all;
}

} // namespace

std::vector<RegionCandidate> findRegionCandidates(RegionObservation& observation, double radius,
                                                  const std::optional<WorldBox>& bounds,
                                                  std::size_t limit) {
  const auto regions = regionsOf(observation);
  std::vector<RegionCandidate> all;
  const auto consider = [&](const std::vector<const Seen*>& members) {
    auto candidate = candidateOf(members, radius);
    if (!candidate || (bounds && !bounds->contains(candidate->center))) {
      return false;
    }
    std::size_t inView = 0;
    for (const auto& view : observation.views()) {
      inView += isInView(view, candidate->center) ? 1 : 0;
    }
    candidate->misfit += kMissing * static_cast<double>(inView - std::min(inView, members.size()));
    all.push_back(*candidate);
    return true;
  };
  for (std::size_t a = 0; a < regions.size(); ++a) {
    for (std::size_t b = a + 1; b < regions.size(); ++b) {
      for (const Seen& first : regions[a]) {
        for (const Seen& second : regions[b]) {
          std::vector<const Seen*> members{&first, &second};
          if (!consider(members)) {
            continue;
          }
          for (std::size_t c = 0; c < regions.size(); ++c) {
            if (c == a || c == b || regions[c].empty()) {
              continue;
            }
            const Eigen::Vector3d center = all.back().center;
            const Seen& nearest = *std::ranges::min_element(
                regions[c], {}, [&](const Seen& seen) { return rayCost(seen, center); });
            members.push_back(&nearest);
            if (!consider(members)) {
              members.pop_back();
            }
          }
        }
      }
    }
  }
  std::ranges::stable_sort(all, {}, [](const RegionCandidate& candidate) {
    return 0.5 * candidate.misfit - candidate.logRarity;
  });
  std::vector<RegionCandidate> best;
  for (const RegionCandidate& candidate : all) {
    const bool again = std::ranges::any_of(best, [&](const RegionCandidate& other) {
      return (other.center - candidate.center).norm() < std::max(other.radius, candidate.radius);
    });
    if (!again && best.size() < limit) {
      best.push_back(candidate);
    }
  }
  return best;
}

} // namespace dewpoint::tracking
