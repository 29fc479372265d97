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

/// CandidateSearch in pieces that are spread over several frames, as the time budget allows. All
/// pieces use the images of the frame in which the search began, so the result refers to this
/// frame.
class SlicedSearch {
public:
  /// Prepares a search in `frames` for targets of `radius` meters (0 if unknown). Candidates lie
  /// within the bounds.
  SlicedSearch(const CameraRig& rig, AdaptiveColor color, double radius, FrameSetPtr frames,
               const std::optional<WorldBox>& bounds = std::nullopt);

  /// Returns the observation in which the search looks for candidates. The caller must pass images
  /// to the observation before the first advance().
  SphereObservation& observation() { return observation_; }
  const AdaptiveColor& color() const { return color_; }

  /// Processes as many pieces as time allows, at least one if `urgent`, and finds at most `limit`
  /// candidates. Returns whether the search is finished.
  bool advance(const CandidateSearch& search, TimeBudget& budget, std::size_t limit, bool urgent);
  /// Returns the candidates that CandidateSearch::find() would return. Call it after the search is
  /// finished.
  const std::vector<Candidate>& candidates() const { return candidates_; }

private:
  bool labelsDone() const;
  void labelBand();

  FrameSetPtr frames_; ///< keeps the images alive
  SphereObservation observation_;
  AdaptiveColor color_;
  double radius_;
  std::optional<WorldBox> bounds_;
  std::size_t camera_ = 0; ///< camera in progress; the candidates follow after the last camera
  std::vector<std::vector<CandidateSearch::Spot>> spots_;
  std::vector<Candidate> candidates_;
};

/// Continues a search (SlicedSearch::advance()). When the search is finished, returns its
/// candidates and sets `search` to null. Until then, returns no candidates. Finds at most four
/// candidates, because an outline must be fitted at each candidate.
std::vector<Candidate> advanceSearch(std::unique_ptr<SlicedSearch>& search,
                                     const CandidateSearch& candidates, TimeBudget& budget,
                                     std::size_t limit, bool urgent);

} // namespace dewpoint::tracking
