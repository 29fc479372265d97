// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/run_definition.h"

#include <cstdint>
#include <vector>

namespace dewpoint::session {

/// Frames from `firstFrame` to `lastFrame`, both included.
struct ResultRange {
  std::int64_t firstFrame = 0;
  std::int64_t lastFrame = 0;
  bool operator==(const ResultRange&) const = default;
};

/// Results of a run that came from settings other than the current ones.
struct OldResults {
  /// Frames with old results, in ascending order; empty if all results come from the current
  /// settings.
  std::vector<ResultRange> frameRanges;
  /// Last frame with results, whether old or not; -1 if there is none.
  std::int64_t newestFrame = -1;
  /// Time in seconds to track a frame again (median of the last frames); 0 if unknown.
  double secondsPerFrame = 0.0;
};

/// Returns whether results obtained with the settings `a` remain valid with the settings `b`. Names
/// of targets and their color samples are ignored. So are corrections, and boxes of methods that
/// track again automatically: when the user changes them, the run goes back immediately.
bool giveSameResults(const RunDefinition& a, const RunDefinition& b);

/// Settings with which each frame of a run was tracked.
class ResultSettings {
public:
  void clear() { sections_.clear(); }
  /// Removes the settings of this frame and of later ones.
  void goBack(std::int64_t frame);
  /// Stores that a frame was tracked with these settings. Earlier data of this frame and of later
  /// ones are removed.
  void recordTrackedFrame(std::int64_t frame, const RunDefinitionPtr& definition);
  /// Returns the frames whose results came from settings other than `now`.
  std::vector<ResultRange> framesDifferingFrom(const RunDefinition& now) const;
  /// Returns the last frame with results; -1 if there is none.
  std::int64_t newestFrame() const {
    return sections_.empty() ? -1 : sections_.back().frames.lastFrame;
  }

private:
  /// Consecutive frames that were tracked with the same settings.
  struct Section {
    ResultRange frames;
    RunDefinitionPtr definition;
  };
  std::vector<Section> sections_; ///< ascending frames
};

} // namespace dewpoint::session
