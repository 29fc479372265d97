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

/// Finds objects that look like a target and are none, and has them tracked while all targets are
/// visible: so none of them can be taken for a target when one hides the other.
class DistractorSearch {
public:
  /// What one search works with. References are valid during the call only.
  struct Context {
    TrackedObjects& objects;
    const FrameImages& images;
    const CandidateSearch& candidates;
    TimeBudget& budget;
    BernoulliTrackSettings settings; ///< of the tracks of new distractors
    RandomKey key;                   ///< of the run, in this frame
  };

  DistractorSearch() = default;
  /// A copy has no search under way: it begins again. A run with a time budget cannot be repeated
  /// bit by bit anyway.
  DistractorSearch(const DistractorSearch& other);
  DistractorSearch& operator=(const DistractorSearch&) = delete;
  ~DistractorSearch() = default;

  /// A new run with this many targets.
  void restart(std::size_t targetCount);
  /// Ends the search under way.
  void cancel() { sliced_.reset(); }
  /// Removes distractors that are lost, or hardly visible after some updates.
  static void removeLost(TrackedObjects& objects);
  /// Once per frame, after all updates: searches the images every few frames, and adds at most one
  /// distractor per color. Within a time budget a search is spread over several frames.
  void search(const Context& context, ThreadTeam& team);

private:
  void searchFor(std::size_t target, const Context& context, ThreadTeam& team);
  void searchInSlices(const Context& context, ThreadTeam& team);
  void add(TrackedObject distractor, const Candidate& candidate, const Context& context,
           ThreadTeam& team);

  std::int64_t frameCount_ = 0;  ///< since the restart
  std::uint32_t nextStream_ = 0; ///< of the next distractor
  std::unique_ptr<SlicedSearch> sliced_;
  std::size_t slicedTarget_ = 0;     ///< whose distractors `sliced_` searches for
  std::int64_t nextSlicedFrame_ = 0; ///< frame count before which no sliced search begins
};

} // namespace dewpoint::tracking
