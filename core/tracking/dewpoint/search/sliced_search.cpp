// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/search/sliced_search.h"

#include <algorithm>
#include <utility>

namespace dewpoint::tracking {
namespace {

// Judgments (docs/method-dewpoint.md, section 10).

constexpr int kBands = 4; ///< pieces in which the labels of an image are made
/// Within a budget; each candidate costs an outline fit.
constexpr std::size_t kMaxCandidatesOnBudget = 4;

} // namespace

SlicedSearch::SlicedSearch(const CameraRig& rig, AdaptiveColor color, double radius,
                           FrameSetPtr frames, const std::optional<WorldBox>& bounds)
    : frames_(std::move(frames)), observation_(rig), color_(std::move(color)), radius_(radius),
      bounds_(bounds), spots_(rig.size()) {}

bool SlicedSearch::labelsDone() const {
  const LabelImage& labels = observation_.labels(camera_);
  return labels.empty() || labels.labeledArea() == cv::Rect({0, 0}, labels.size());
}

void SlicedSearch::labelBand() {
  LabelImage& labels = observation_.labels(camera_);
  const cv::Size size = labels.size();
  const int begin = labels.labeledArea().height;
  labels.ensureLabels({0, begin, size.width, (size.height + kBands - 1) / kBands});
}

bool SlicedSearch::advance(const CandidateSearch& search, TimeBudget& budget, std::size_t limit,
                           bool urgent) {
  bool must = urgent;
  while (camera_ < spots_.size()) {
    const bool labeled = labelsDone();
    const bool empty = observation_.labels(camera_).empty();
    const bool done =
        empty || (labeled ? budget.runIfAffordable(
                                TimeBudget::Stage::Spots,
                                [&] {
                                  spots_[camera_] =
                                      search.findSpots(camera_, observation_.labels(camera_));
                                },
                                must)
                          : budget.runIfAffordable(
                                TimeBudget::Stage::Labels, [&] { labelBand(); }, must));
    if (!done) {
      return false;
    }
    camera_ += labeled ? 1 : 0;
    must = must && empty;
  }
  observation_.setRadius(radius_);
  return budget.runIfAffordable(
      TimeBudget::Stage::Candidates,
      [&] {
        candidates_ = search.triangulate(spots_, observation_, radius_ > 0.0, limit, bounds_);
      },
      must);
}

std::vector<Candidate> advanceSearch(std::unique_ptr<SlicedSearch>& search,
                                     const CandidateSearch& candidates, TimeBudget& budget,
                                     std::size_t limit, bool urgent) {
  if (!search->advance(candidates, budget, std::min(limit, kMaxCandidatesOnBudget), urgent)) {
    return {};
  }
  auto found = search->candidates();
  search.reset();
  return found;
}

} // namespace dewpoint::tracking
