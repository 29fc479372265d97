// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/run_definition.h"

#include <cstdint>
#include <vector>

namespace dewpoint::session {

/// Frames from `first` to `last`, both included.
struct ResultRange {
  std::int64_t first = 0;
  std::int64_t last = 0;
  bool operator==(const ResultRange&) const = default;
};

/// Results of a run that came from settings other than the current ones.
struct OldResults {
  std::vector<ResultRange>
      frames;                   ///< by rising frame; empty: all results are of the settings of now
  std::int64_t newest = -1;     ///< the last frame with results, old or not; -1: there is none
  double secondsPerFrame = 0.0; ///< to track a frame again (median of the last ones); 0: unknown
};

/// Returns whether results obtained with `a` remain valid with `b`. Names of targets and their
/// color samples have no effect on this. Corrections and, if they are tracked again automatically,
/// boxes are also ignored: the run goes back at once when they change.
bool giveSameResults(const RunDefinition& a, const RunDefinition& b);

/// Settings with which each frame of a run was tracked.
class ResultSettings {
public:
  void clear() { stretches_.clear(); }
  /// Removes this frame and later ones.
  void goBack(std::int64_t frame);
  /// Adds a tracked frame; earlier data of this frame and later ones are replaced.
  void track(std::int64_t frame, const RunDefinitionPtr& definition);
  /// Frames whose results other settings gave than these.
  std::vector<ResultRange> differentFrom(const RunDefinition& now) const;
  /// The last frame with results; -1: there is none.
  std::int64_t newest() const { return stretches_.empty() ? -1 : stretches_.back().frames.last; }

private:
  /// Consecutive frames that were tracked with the same settings.
  struct Stretch {
    ResultRange frames;
    RunDefinitionPtr definition;
  };
  std::vector<Stretch> stretches_; ///< ascending frames
};

} // namespace dewpoint::session
