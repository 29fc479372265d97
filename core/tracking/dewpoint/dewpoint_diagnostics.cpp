// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/dewpoint_diagnostics.h"

#include "core/observation/sphere/sphere_evidence.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace dewpoint::tracking {
namespace {

// Origin not recorded.

/// Share of the learned pixels of an image that show something new: the camera is covered or moved.
constexpr double kCoveredShare = 0.85;
/// Share of the pixels inside an outline that show something new: a part of the target is hidden.
constexpr double kPartlyShare = 0.15;
/// The same share for a target that is not seen: it is hidden.
constexpr double kHiddenShare = 0.4;
/// Pixels between two outlines within which an object of the same color may be mistaken for the
/// target; at least the target's radius.
constexpr double kBesidePx = 12.0;

/// Share of the pixels inside an outline that show something new, 0 to 1.
double unknownShare(const LabelImage& labels, const SphereImage& outline) {
  int unknown = 0;
  int all = 0;
  const cv::Rect area = areaOf(outline, 1.0, 0.0) & labels.labeledArea();
  for (int row = area.y; row < area.y + area.height; ++row) {
    for (int column = area.x; column < area.x + area.width; ++column) {
      if ((Eigen::Vector2d(column, row) - outline.center).norm() <= outline.radius) {
        unknown += labels.at(column, row) == PixelLabel::Unknown ? 1 : 0;
        ++all;
      }
    }
  }
  return all > 0 ? static_cast<double>(unknown) / all : 0.0;
}

std::optional<double> distanceToLabel(const LabelImage& labels, PixelLabel label,
                                      const Eigen::Vector2d& point) {
  cv::Mat mask;
  cv::compare(labels.labels(), static_cast<int>(label), mask, cv::CMP_EQ);
  return distanceToNearestMaskPixel(mask, point);
}

double gapBetween(const SphereImage& a, const SphereImage& b) {
  return std::max(0.0, (a.center - b.center).norm() - a.radius - b.radius);
}

/// Pixels between the outline of a target and that of the nearest distractor beside it; while the
/// estimate is not valid, also of a rival hypothesis, wherever it is.
std::optional<double> gapToDistractor(const TrackedObjects& objects, const SphereEstimate& estimate,
                                      std::size_t target, std::size_t camera,
                                      const SphereImage& outline) {
  const TrackedObject& own = objects[target];
  const SphereProjector& projector = own.observation.projector(camera);
  std::optional<double> nearest;
  const auto consider = [&](const TrackHypothesis& other, double farthest) {
    const auto seen = projector.project(other.position(), other.radius);
    const double gap = seen ? gapBetween(outline, *seen) : farthest + 1.0;
    if (gap <= farthest && (!nearest || gap < *nearest)) {
      nearest = gap;
    }
  };
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const TrackHypothesis* other = k != target ? objects[k].track.confidentHypothesis() : nullptr;
    if (other != nullptr && haveSameColor(objects[k], own)) {
      consider(*other, std::max(kBesidePx, outline.radius));
    }
  }
  if (!estimate.isValid) {
    const auto& hypotheses = own.track.hypotheses();
    for (std::size_t k = 1; k < hypotheses.size(); ++k) {
      if (hypotheses[k].isSaturated()) {
        consider(hypotheses[k], 1e9);
      }
    }
  }
  return nearest;
}

CameraReport explainCamera(const TrackedObjects& objects, const FrameImages& images,
                           const SphereEstimate& estimate, std::size_t target, std::size_t camera,
                           const std::optional<OccupiedSphere>& expected) {
  const FramePtr frame = images.frame(camera);
  const SphereObservation& observation = objects[target].observation;
  const LabelImage& labels = observation.labels(camera);
  if (!frame || labels.empty()) {
    return {CameraStatus::NoImage, 0.0};
  }
  const bool seen =
      camera < estimate.cameras.size() && estimate.cameras[camera].visibleShare >= kSeenShare;
  if (!seen && isDark(frame->image)) {
    return {CameraStatus::Dark, 0.0};
  }
  const auto outline =
      expected ? observation.projector(camera).project(expected->center, expected->radius)
               : std::nullopt;
  const auto gap = outline && !(seen && estimate.isValid)
                       ? gapToDistractor(objects, estimate, target, camera, *outline)
                       : std::nullopt;
  if (gap) {
    return {CameraStatus::Distractor, *gap};
  }
  if (seen) {
    const bool partly = estimate.cameras[camera].visibleShare < kWholeShare && outline &&
                        unknownShare(labels, *outline) >= kPartlyShare;
    return {partly ? CameraStatus::PartlyHidden : CameraStatus::None, 0.0};
  }
  if (images.background(camera).novelPixelShare() > kCoveredShare) {
    return {CameraStatus::Covered, 0.0};
  }
  if (expected && (!outline || !isInImage(*outline, labels.size()))) {
    return {CameraStatus::OutOfView, 0.0};
  }
  if (outline && unknownShare(labels, *outline) >= kHiddenShare) {
    return {CameraStatus::Hidden, 0.0};
  }
  // An image of which only a part has labels was not searched: the target was expected there.
  if (labels.labeledArea().size() != labels.size()) {
    return {CameraStatus::Hidden, 0.0};
  }
  const Eigen::Vector2d center = outline ? outline->center : Eigen::Vector2d(0.0, 0.0);
  const auto distance = distanceToLabel(labels, PixelLabel::Target, center);
  if (!distance) {
    return {outline ? CameraStatus::Hidden : CameraStatus::NoColor, 0.0};
  }
  return outline ? CameraReport{CameraStatus::Elsewhere, std::max(0.0, *distance - outline->radius)}
                 : CameraReport{CameraStatus::Unclear, 0.0};
}

} // namespace

std::vector<CameraReport> cameraReportsOf(const TrackedObjects& objects, const FrameImages& images,
                                          const SphereEstimate& estimate, std::size_t target) {
  const auto expected = objects[target].track.expectedSphere();
  std::vector<CameraReport> reports;
  for (std::size_t camera = 0; camera < images.cameraCount(); ++camera) {
    reports.push_back(explainCamera(objects, images, estimate, target, camera, expected));
  }
  return reports;
}

std::vector<CandidatePosition> candidatePositions(const TrackedObjects& objects,
                                                  std::size_t target) {
  std::vector<CandidatePosition> all;
  const auto add = [&all](const TrackHypothesis& hypothesis, CandidatePosition::Kind kind) {
    all.push_back({kind, hypothesis.position(), hypothesis.radius, hypothesis.probability,
                   hypothesis.logLikelihoodRatio});
  };
  for (const TrackHypothesis& hypothesis : objects[target].track.hypotheses()) {
    add(hypothesis, hypothesis.updateCount > 0 ? CandidatePosition::Kind::Existing
                                               : CandidatePosition::Kind::New);
  }
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const TrackHypothesis* other = k != target ? objects[k].track.confidentHypothesis() : nullptr;
    if (other != nullptr && haveSameColor(objects[k], objects[target])) {
      add(*other, CandidatePosition::Kind::Distractor);
    }
  }
  return all;
}

std::vector<LikelihoodMap> likelihoodMapsOf(const TrackedObjects& objects,
                                            const FrameImages& images,
                                            const SphereEstimate& estimate, std::size_t target,
                                            int reach) {
  const std::size_t cameraCount = images.cameraCount();
  std::vector<LikelihoodMap> maps(cameraCount);
  const TrackedObject& own = objects[target];
  const double radius = estimate.radius > 0.0 ? estimate.radius : own.track.target().radius;
  // Labels of its own: making more of them must not change what the tracker does next.
  SphereObservation observation = objects.makeObservation();
  images.passImagesTo(observation, own.color);
  objects.markPixelsOfOthers(observation, own);
  for (std::size_t camera = 0; camera < cameraCount; ++camera) {
    LabelImage& labels = observation.labels(camera);
    const auto outline = observation.projector(camera).project(estimate.mean, radius);
    // The map is that of a ball.
    if (labels.empty() || !outline || !isInImage(*outline, labels.size()) || radius <= 0.0 ||
        estimate.extent) {
      continue;
    }
    LikelihoodMap& map = maps[camera];
    const cv::Rect whole(cv::Point(0, 0), labels.size());
    map.area = cv::Rect(static_cast<int>(std::lround(outline->center.x())) - reach,
                        static_cast<int>(std::lround(outline->center.y())) - reach, 2 * reach + 1,
                        2 * reach + 1) &
               whole;
    map.maxLogLikelihood = SphereEvidence::maxLogLikelihoodRatio();
    map.minLogLikelihood = -map.maxLogLikelihood;
    map.logLikelihood.create(map.area.size(), CV_32F);
    SphereImage moved = *outline;
    labels.ensureLabels(areaOf(moved, SphereEvidence::kSampleReach, reach + 2.0));
    for (int row = 0; row < map.area.height; ++row) {
      for (int column = 0; column < map.area.width; ++column) {
        moved.center = Eigen::Vector2d(map.area.x + column, map.area.y + row);
        map.logLikelihood.at<float>(row, column) =
            static_cast<float>(SphereEvidence::logLikelihoodRatio(labels, moved));
      }
    }
  }
  return maps;
}

} // namespace dewpoint::tracking
