// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/run_definition.h"

#include <cstdint>
#include <vector>

namespace dewpoint::session {

/// Frames from `first` to `last`, both included.
struct FrameSpan {
  std::int64_t first = 0;
  std::int64_t last = 0;
  bool operator==(const FrameSpan&) const = default;
};

/// Results of a run that other settings gave than those of now.
struct OldResults {
  std::vector<FrameSpan> frames; ///< by rising frame; empty: all results are of the settings of now
  std::int64_t newest = -1;      ///< the last frame with results, old or not; -1: there is none
  double secondsPerFrame = 0.0;  ///< to track a frame again (median of the last ones); 0: unknown
};

/// Whether a frame that was tracked with `a` need not be tracked again because of `b`. Names of
/// targets and the samples of their colors decide nothing, nor do corrections and, where they are
/// tracked again by themselves, boxes: the run goes back for those at once.
bool giveSameResults(const RunDefinition& a, const RunDefinition& b);

/// The settings that each frame of a run was tracked with.
class ResultSettings {
public:
  void clear() { stretches_.clear(); }
  /// Forgets this frame and later ones.
  void goBack(std::int64_t frame);
  /// A frame was tracked; what was known of it and of later ones is void.
  void track(std::int64_t frame, const RunDefinitionPtr& definition);
  /// Frames whose results other settings gave than these.
  std::vector<FrameSpan> differentFrom(const RunDefinition& now) const;
  /// The last frame with results; -1: there is none.
  std::int64_t newest() const { return stretches_.empty() ? -1 : stretches_.back().frames.last; }

private:
  /// Frames in a row that were tracked with the same settings.
  struct Stretch {
    FrameSpan frames;
    RunDefinitionPtr definition;
  };
  std::vector<Stretch> stretches_; ///< by rising frame
};

} // namespace dewpoint::session
