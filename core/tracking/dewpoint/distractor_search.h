// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/dewpoint/frame_images.h"
#include "core/tracking/dewpoint/search/candidate_search.h"
#include "core/tracking/dewpoint/search/sliced_search.h"
#include "core/tracking/dewpoint/search/time_budget.h"
#include "core/tracking/dewpoint/tracked_objects.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace dewpoint::tracking {

/// Finds distractors, which are objects that look like a target but are not targets, and starts
/// tracking them while all targets are visible. When a target is hidden later, such an object is
/// not mistaken for the target.
class DistractorSearch {
public:
  /// Inputs of a search. The references need to be valid during the call only.
  struct Context {
    TrackedObjects& objects;
    const FrameImages& images;
    const CandidateSearch& candidates;
    TimeBudget& budget;
    BernoulliTrackSettings settings; ///< for the tracks of new distractors
    RandomKey key;                   ///< key of the random numbers of the run in this frame
  };

  DistractorSearch() = default;
  /// Copies everything except the search in progress; the copy starts a new search. Only runs with
  /// a time budget have a search in progress, and such runs are not reproducible bit by bit anyway.
  DistractorSearch(const DistractorSearch& other);
  DistractorSearch& operator=(const DistractorSearch&) = delete;
  ~DistractorSearch() = default;

  /// Prepares for a new run with this number of targets.
  void restart(std::size_t targetCount);
  /// Cancels the search in progress.
  void cancel() { sliced_.reset(); }
  /// Removes distractors that are lost, or hardly visible after several updates.
  static void removeLostDistractors(TrackedObjects& objects);
  /// Searches the images every few frames and adds at most one distractor per color. Call this
  /// function once per frame, after all updates. If there is a time budget, a search is spread over
  /// several frames.
  void search(const Context& context, ThreadTeam& team);

private:
  void searchFor(std::size_t target, const Context& context, ThreadTeam& team);
  void searchInSlices(const Context& context, ThreadTeam& team);
  void add(TrackedObject distractor, const Candidate& candidate, const Context& context,
           ThreadTeam& team);

  std::int64_t frameCount_ = 0;  ///< number of frames since the restart
  std::uint32_t nextStream_ = 0; ///< stream of the next distractor
  std::unique_ptr<SlicedSearch> sliced_;
  std::size_t slicedTarget_ = 0;     ///< target whose distractors `sliced_` searches for
  std::int64_t nextSlicedFrame_ = 0; ///< frame count before which no new sliced search begins
};

} // namespace dewpoint::tracking
