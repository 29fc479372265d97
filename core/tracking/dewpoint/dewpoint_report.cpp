// SPDX-License-Identifier: GPL-3.0-or-later
// What method dewpoint tells of itself: copies, reasons, proposals and likelihood maps.
#include "core/observation/sphere/sphere_evidence.h"
#include "core/tracking/dewpoint/dewpoint_tracker.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>

namespace dewpoint::tracking {
namespace {

constexpr double kCoveredShare = 0.85; ///< of the image that shows something new
constexpr double kPartlyShare = 0.15;  ///< of the outline that shows something new
constexpr double kHiddenShare = 0.4;   ///< of the outline that shows something new
constexpr double kBesidePx = 12.0;     ///< a look-alike so near may be mistaken for the target

/// Share of an outline whose labels say that something new is there.
double unknownShare(const LabelImage& labels, const SphereImage& outline) {
  int unknown = 0;
  int all = 0;
  const cv::Rect area = areaOf(outline, 1.0, 0.0) & labels.covered();
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
  return distanceToNearest(mask, point);
}

bool isInside(const SphereImage& outline, const cv::Size& size) {
  return outline.center.x() >= 0.0 && outline.center.y() >= 0.0 &&
         outline.center.x() <= size.width - 1 && outline.center.y() <= size.height - 1;
}

double gapBetween(const SphereImage& a, const SphereImage& b) {
  return std::max(0.0, (a.center - b.center).norm() - a.radius - b.radius);
}

} // namespace

DewpointTracker::DewpointTracker(const DewpointTracker& other)
    : Tracker(), parameters_(other.parameters_), rig_(other.rig_), targetCount_(other.targetCount_),
      frameCount_(other.frameCount_), nextLookAlike_(other.nextLookAlike_),
      streams_(other.streams_), backgrounds_(other.backgrounds_), search_(other.search_),
      frames_(other.frames_), lastTime_(other.lastTime_), key_(other.key_),
      estimates_(other.estimates_), budget_(other.budget_), lookAroundFor_(other.lookAroundFor_),
      nextLookAround_(other.nextLookAround_) {
  for (const Tracked& tracked : other.tracked_) {
    // Searches that go on within a time budget begin anew: such a run cannot be repeated anyway.
    tracked_.push_back({tracked.belief, SphereObservation(rig_), tracked.color, nullptr});
  }
}

std::unique_ptr<Tracker> DewpointTracker::clone() const {
  return std::unique_ptr<Tracker>(new DewpointTracker(*this));
}

std::size_t DewpointTracker::memoryBytes() const {
  std::size_t bytes = 0;
  for (const BackgroundModel& background : backgrounds_) {
    bytes += background.memoryBytes();
  }
  for (const Tracked& tracked : tracked_) {
    bytes += tracked.belief.memoryBytes();
  }
  return bytes;
}

std::optional<double> DewpointTracker::gapToLookAlike(std::size_t target, std::size_t camera,
                                                      const SphereImage& outline) const {
  const Tracked& own = tracked_[target];
  const SphereProjector& projector = own.observation.projector(camera);
  std::optional<double> nearest;
  const auto consider = [&](const TrackHypothesis& other, double farthest) {
    const auto seen = projector.project(other.position(), other.radius);
    const double gap = seen ? gapBetween(outline, *seen) : farthest + 1.0;
    if (gap <= farthest && (!nearest || gap < *nearest)) {
      nearest = gap;
    }
  };
  for (std::size_t k = 0; k < tracked_.size(); ++k) {
    const TrackHypothesis* other = k != target ? tracked_[k].belief.confident() : nullptr;
    if (other != nullptr && tracked_[k].belief.target().color == own.belief.target().color) {
      consider(*other, std::max(kBesidePx, outline.radius));
    }
  }
  if (!estimates_[target].valid) { // rivals of one's own, wherever they are
    const auto& hypotheses = own.belief.hypotheses();
    for (std::size_t k = 1; k < hypotheses.size(); ++k) {
      if (hypotheses[k].isSaturated()) {
        consider(hypotheses[k], 1e9);
      }
    }
  }
  return nearest;
}

CameraReport DewpointTracker::explain(std::size_t target, std::size_t camera,
                                      const std::optional<OccupiedSphere>& expected) const {
  const FramePtr frame = frameOf(camera);
  const LabelImage& labels = tracked_[target].observation.labels(camera);
  if (!frame || labels.empty()) {
    return {CameraStatus::NoImage, 0.0};
  }
  const SphereEstimate& estimate = estimates_[target];
  const bool seen =
      camera < estimate.cameras.size() && estimate.cameras[camera].visible >= kSeenShare;
  if (!seen && isDark(frame->image)) {
    return {CameraStatus::Dark, 0.0};
  }
  const auto outline = expected ? tracked_[target].observation.projector(camera).project(
                                      expected->center, expected->radius)
                                : std::nullopt;
  const auto lookAlike = outline && !(seen && estimate.valid)
                             ? gapToLookAlike(target, camera, *outline)
                             : std::nullopt;
  if (lookAlike) {
    return {CameraStatus::Distractor, *lookAlike};
  }
  if (seen) {
    const bool partly = estimate.cameras[camera].visible < kWholeShare && outline &&
                        unknownShare(labels, *outline) >= kPartlyShare;
    return {partly ? CameraStatus::PartlyHidden : CameraStatus::None, 0.0};
  }
  if (backgrounds_[camera].novelShare() > kCoveredShare) {
    return {CameraStatus::Covered, 0.0};
  }
  if (expected && (!outline || !isInside(*outline, labels.size()))) {
    return {CameraStatus::OutOfView, 0.0};
  }
  if (outline && unknownShare(labels, *outline) >= kHiddenShare) {
    return {CameraStatus::Hidden, 0.0};
  }
  if (labels.covered().size() !=
      labels.size()) { // the image was not searched: it was expected here
    return {CameraStatus::Hidden, 0.0};
  }
  const Eigen::Vector2d middle = outline ? outline->center : Eigen::Vector2d(0.0, 0.0);
  const auto distance = distanceToLabel(labels, PixelLabel::Target, middle);
  if (!distance) {
    return {outline ? CameraStatus::Hidden : CameraStatus::NoColor, 0.0};
  }
  return outline ? CameraReport{CameraStatus::Elsewhere, std::max(0.0, *distance - outline->radius)}
                 : CameraReport{CameraStatus::Unclear, 0.0};
}

std::vector<CameraReport> DewpointTracker::explain(std::size_t target) const {
  const auto expected = tracked_.at(target).belief.expectedSphere();
  std::vector<CameraReport> reports;
  for (std::size_t camera = 0; camera < rig_.size(); ++camera) {
    reports.push_back(explain(target, camera, expected));
  }
  return reports;
}

std::vector<CandidatePosition> DewpointTracker::proposals(std::size_t target) const {
  std::vector<CandidatePosition> all;
  const auto add = [&all](const TrackHypothesis& hypothesis, CandidatePosition::Kind kind) {
    all.push_back({kind, hypothesis.position(), hypothesis.radius, hypothesis.probability,
                   hypothesis.logLikelihoodRatio});
  };
  for (const TrackHypothesis& hypothesis : tracked_.at(target).belief.hypotheses()) {
    add(hypothesis, hypothesis.updateCount > 0 ? CandidatePosition::Kind::Existing
                                               : CandidatePosition::Kind::New);
  }
  for (std::size_t k = 0; k < tracked_.size(); ++k) {
    const TrackHypothesis* other = k != target ? tracked_[k].belief.confident() : nullptr;
    if (other != nullptr &&
        tracked_[k].belief.target().color == tracked_[target].belief.target().color) {
      add(*other, CandidatePosition::Kind::Distractor);
    }
  }
  return all;
}

std::vector<LikelihoodMap> DewpointTracker::likelihoodMaps(std::size_t target, int reach) const {
  std::vector<LikelihoodMap> maps(rig_.size());
  const SphereEstimate& estimate = estimates_.at(target);
  const double radius =
      estimate.radius > 0.0 ? estimate.radius : tracked_[target].belief.target().radius;
  DewpointTracker copy(*this); // making labels must not change what this one does next
  Tracked& own = copy.tracked_[target];
  copy.showImages(own.observation, own.color);
  copy.explainOthers(own.observation, own);
  for (std::size_t camera = 0; camera < rig_.size(); ++camera) {
    LabelImage& labels = own.observation.labels(camera);
    const auto outline = own.observation.projector(camera).project(estimate.mean, radius);
    if (labels.empty() || !outline || !isInside(*outline, labels.size()) || radius <= 0.0) {
      continue;
    }
    LikelihoodMap& map = maps[camera];
    const cv::Rect whole(cv::Point(0, 0), labels.size());
    map.area = cv::Rect(static_cast<int>(std::lround(outline->center.x())) - reach,
                        static_cast<int>(std::lround(outline->center.y())) - reach, 2 * reach + 1,
                        2 * reach + 1) &
               whole;
    map.most = SphereEvidence::best();
    map.least = -map.most;
    map.logLikelihood.create(map.area.size(), CV_32F);
    SphereImage moved = *outline;
    labels.require(areaOf(moved, SphereEvidence::kReach, reach + 2.0));
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
