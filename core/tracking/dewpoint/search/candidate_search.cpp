// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/search/candidate_search.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace dewpoint::tracking {
namespace {

// Judgments (docs/method-dewpoint.md, section 5).

constexpr std::size_t kMaxSpots = 24;   ///< per camera, the largest ones
constexpr double kSmallestSpotPx = 1.2; ///< pixels, inscribed radius
constexpr double kSizeTolerance = 2.2;  ///< expected size by seen size: a part may be hidden
constexpr double kSizeExcess = 1.4;     ///< seen size by expected size
constexpr double kUnknownGap = 0.1;     ///< meters between rays, for an unknown radius
constexpr double kKnownGapRadii = 1.5;  ///< radii between rays, for a known radius
constexpr std::size_t kMaxScored = 200; ///< candidates whose likelihood is computed

/// Whether the sizes of two spots, or of a spot and a target of known radius, may be of one object.
bool sizeFits(double seen, double expected) {
  return seen < kSizeExcess * expected && seen * kSizeTolerance > expected;
}

} // namespace

CandidateSearch::CandidateSearch(const CameraRig& rig) {
  for (const Camera& camera : rig) {
    unprojectors_.emplace_back(camera);
    focals_.push_back(std::sqrt(camera.intrinsics.focalX * camera.intrinsics.focalY));
  }
}

std::vector<CandidateSearch::Spot> CandidateSearch::findSpots(std::size_t camera,
                                                              const LabelImage& labels) const {
  // Local maxima of the distance to the nearest pixel of another color are the centers of the
  // largest circles that fit in: one per ball, also where two touch.
  cv::Mat whole;
  cv::compare(labels.labels(), static_cast<int>(PixelLabel::Target), whole, cv::CMP_EQ);
  const cv::Rect area = cv::boundingRect(whole);
  if (area.empty()) {
    return {};
  }
  const cv::Mat mask = whole(area);
  cv::Mat closed;
  // Single odd pixels inside would split a disc.
  cv::medianBlur(mask, closed, 3);
  cv::Mat framed;
  cv::copyMakeBorder(closed, framed, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::Mat distance;
  cv::distanceTransform(framed, distance, cv::DIST_L2, 5);
  cv::Mat highest;
  cv::dilate(distance, highest, cv::Mat::ones(5, 5, CV_8UC1));
  struct Peak {
    float radius;
    int column;
    int row;
  };
  std::vector<Peak> peaks;
  for (int row = 1; row < distance.rows - 1; ++row) {
    const auto* here = distance.ptr<float>(row);
    const auto* most = highest.ptr<float>(row);
    for (int column = 1; column < distance.cols - 1; ++column) {
      if (here[column] >= kSmallestSpotPx && here[column] >= most[column]) {
        peaks.push_back({here[column], area.x + column - 1, area.y + row - 1});
      }
    }
  }
  std::stable_sort(peaks.begin(), peaks.end(),
                   [](const Peak& a, const Peak& b) { return a.radius > b.radius; });
  std::vector<Spot> spots;
  std::vector<Peak> taken;
  for (const Peak& peak : peaks) {
    // A plateau or a ridge gives many maxima; one per half radius is enough.
    const bool again = std::any_of(taken.begin(), taken.end(), [&](const Peak& other) {
      return std::hypot(other.column - peak.column, other.row - peak.row) < 0.5 * other.radius;
    });
    const auto ray = unprojectors_[camera].ray({peak.column, peak.row});
    if (!again && ray && spots.size() < kMaxSpots) {
      taken.push_back(peak);
      spots.push_back({*ray, peak.radius});
    }
  }
  return spots;
}

std::vector<Candidate> CandidateSearch::find(SphereObservation& observation, bool radiusKnown,
                                             std::size_t limit,
                                             const std::optional<WorldBox>& bounds) const {
  std::vector<std::vector<Spot>> spots(observation.cameraCount());
  for (std::size_t camera = 0; camera < spots.size(); ++camera) {
    LabelImage& labels = observation.labels(camera);
    if (!labels.empty()) {
      labels.ensureAllLabels();
      spots[camera] = findSpots(camera, labels);
    }
  }
  return triangulate(spots, observation, radiusKnown, limit, bounds);
}

std::vector<Candidate> CandidateSearch::triangulate(const std::vector<std::vector<Spot>>& spots,
                                                    SphereObservation& observation,
                                                    bool radiusKnown, std::size_t limit,
                                                    const std::optional<WorldBox>& bounds) const {
  const std::size_t cameras = spots.size();
  const double known = observation.radius();
  struct Raw {
    Eigen::Vector3d center;
    double radius;
    double misfit;
  };
  std::vector<Raw> raws;
  for (std::size_t a = 0; a < cameras; ++a) {
    for (const Spot& first : spots[a]) {
      for (std::size_t b = a + 1; b < cameras; ++b) {
        for (const Spot& second : spots[b]) {
          const auto position = nearestPoint({first.ray, second.ray});
          if (!position) {
            continue;
          }
          const double depthA = (*position - first.ray.origin).norm();
          const double depthB = (*position - second.ray.origin).norm();
          const double radiusA = first.radiusPx * depthA / focals_[a];
          const double radiusB = second.radiusPx * depthB / focals_[b];
          const double radius = radiusKnown ? known : std::sqrt(radiusA * radiusB);
          const double gap =
              distanceToRay(first.ray, *position) + distanceToRay(second.ray, *position);
          const double allowed =
              radiusKnown ? kKnownGapRadii * known : std::min(kUnknownGap, radius);
          const bool fits = radiusKnown ? sizeFits(radiusA, known) && sizeFits(radiusB, known)
                                        : sizeFits(radiusA, radiusB) && sizeFits(radiusB, radiusA);
          if (gap <= allowed && fits) {
            const double size = std::log(radiusA / radius);
            const double other = std::log(radiusB / radius);
            raws.push_back({*position, radius, gap / radius + std::abs(size) + std::abs(other)});
          }
        }
      }
      if (radiusKnown) {
        const double depth = focals_[a] * known / first.radiusPx;
        raws.push_back({first.ray.origin + depth * first.ray.direction, known, 2.0});
      }
    }
  }
  if (bounds) {
    std::erase_if(raws, [&](const Raw& raw) { return !bounds->contains(raw.center); });
  }
  std::stable_sort(raws.begin(), raws.end(),
                   [](const Raw& a, const Raw& b) { return a.misfit < b.misfit; });
  raws.resize(std::min(raws.size(), kMaxScored));
  std::vector<Candidate> scored;
  for (const Raw& raw : raws) {
    observation.setRadius(raw.radius);
    scored.push_back({raw.center, raw.radius,
                      observation.logLikelihoodRatio(raw.center, Eigen::Vector3d::Zero())});
  }
  observation.setRadius(known);
  std::stable_sort(scored.begin(), scored.end(), [](const Candidate& a, const Candidate& b) {
    return a.logLikelihoodRatio > b.logLikelihoodRatio;
  });
  std::vector<Candidate> best;
  for (const Candidate& candidate : scored) {
    const bool again = std::any_of(best.begin(), best.end(), [&](const Candidate& other) {
      return (other.center - candidate.center).norm() < other.radius;
    });
    if (!again && best.size() < limit) {
      best.push_back(candidate);
    }
  }
  return best;
}

} // namespace dewpoint::tracking
