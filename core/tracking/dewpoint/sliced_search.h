// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"
#include "core/observation/sphere/adaptive_color.h"
#include "core/tracking/dewpoint/candidate_search.h"
#include "core/tracking/dewpoint/time_budget.h"

#include <vector>

namespace dewpoint::tracking {

/// A CandidateSearch cut into pieces that are done over several frames, as a time budget allows,
/// all on the images of the frame it began with. What it finds is as old as that frame.
class SlicedSearch {
public:
  SlicedSearch(const CameraRig& rig, AdaptiveColor color, double radius, FrameSetPtr frames);

  /// To be shown the images before the first advance().
  SphereObservation& observation() { return observation_; }
  const AdaptiveColor& color() const { return color_; }

  /// Goes on as far as there is time, by a piece at least when it is urgent; whether it is done.
  bool advance(const CandidateSearch& search, TimeBudget& budget, std::size_t limit, bool urgent);
  /// As CandidateSearch::find(), when done.
  const std::vector<Candidate>& places() const { return places_; }

private:
  bool labelsDone() const;
  void labelBand();

  FrameSetPtr frames_; ///< keeps the images
  SphereObservation observation_;
  AdaptiveColor color_;
  double radius_;
  std::size_t camera_ = 0; ///< at work on this one; when past the last, places are next
  std::vector<std::vector<CandidateSearch::Spot>> spots_;
  std::vector<Candidate> places_;
};

} // namespace dewpoint::tracking
