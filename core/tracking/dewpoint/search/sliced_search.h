// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"
#include "core/observation/sphere/adaptive_color.h"
#include "core/tracking/dewpoint/search/candidate_search.h"
#include "core/tracking/dewpoint/search/time_budget.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// A CandidateSearch in pieces that are done over several frames, as a time budget allows, all on
/// the images of the frame it began with. What it finds is as old as that frame.
class SlicedSearch {
public:
  /// Searches in `frames`; `radius` in meters, 0 when unknown. Candidates lie within the bounds.
  SlicedSearch(const CameraRig& rig, AdaptiveColor color, double radius, FrameSetPtr frames,
               const std::optional<WorldBox>& bounds = std::nullopt);

  /// The observation must be shown the images before the first advance().
  SphereObservation& observation() { return observation_; }
  const AdaptiveColor& color() const { return color_; }

  /// Does as many pieces as there is time for, at least one when it is urgent, and finds at most
  /// `limit` candidates. Returns whether the search is done.
  bool advance(const CandidateSearch& search, TimeBudget& budget, std::size_t limit, bool urgent);
  /// As CandidateSearch::find(), once the search is done.
  const std::vector<Candidate>& candidates() const { return candidates_; }

private:
  bool labelsDone() const;
  void labelBand();

  FrameSetPtr frames_; ///< keeps the images
  SphereObservation observation_;
  AdaptiveColor color_;
  double radius_;
  std::optional<WorldBox> bounds_;
  std::size_t camera_ = 0; ///< the one at work; past the last one candidates are next
  std::vector<std::vector<CandidateSearch::Spot>> spots_;
  std::vector<Candidate> candidates_;
};

/// Advances a search; when it is done, returns its candidates and sets the search to null. Returns
/// none until then. Finds four candidates at most: each costs an outline fit.
std::vector<Candidate> advanceSearch(std::unique_ptr<SlicedSearch>& search,
                                     const CandidateSearch& candidates, TimeBudget& budget,
                                     std::size_t limit, bool urgent);

} // namespace dewpoint::tracking
