// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/log_piece.h"
#include "core/session/people/people_frame.h"
#include "core/session/run/box_track_file.h"
#include "core/session/run/result_settings.h"
#include "core/session/run/run_report.h"
#include "core/session/snapshot/snapshot.h"
#include "core/session/thinned_log.h"
#include "core/trajectory/trajectory.h"

#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::session {

/// Log of a run since its last start or restart. The tracking thread writes it; other threads copy
/// from it.
class RunLog {
public:
  /// About 40 MB with four cameras.
  static constexpr std::size_t kMostRecords = 100000;
  RunLog();
  /// Clears the log. The following records belong to this project in its present state, filtered by
  /// this number of threads.
  void restart(const Project& project, int threads = 1);
  /// Notes that the project has other parameters or corrections from now on. If nothing is recorded
  /// yet, the whole run and the header of its trajectory belong to this project.
  void change(const Project& project);
  void append(const std::vector<IterationRecord>& records);
  /// Appends the samples of one frame. They replace those of the last frame if it is the same.
  void append(const std::vector<TrajectorySample>& samples);
  /// As for samples, but for boxes.
  void append(const std::vector<BoxSample>& samples);
  /// Adds the duration of one filter iteration, in seconds per target.
  void countIteration(double seconds);
  /// Adds a finished frame: seconds since its arrival, and since the arrival of the run's first
  /// frame.
  void countFrame(double sinceArrival, double sinceFirst);
  /// Sets whether the end of the input was reached.
  void setFinished(bool finished);
  /// Sets the number of filter threads.
  void setThreads(int threads);
  /// Removes the records of this frame and later ones; readers receive all records again.
  void goBack(std::int64_t frame);
  /// Renumbers the targets: the former target k becomes numbers[k] of `count` targets, or is
  /// removed if this is -1. Readers receive all records again.
  void renumber(const std::vector<int>& numbers, std::size_t count);
  /// Records from `position` on; both arguments move along. Beyond kMostRecords the older ones are
  /// there in coarser and coarser steps.
  LogPiece<IterationRecord> since(std::uint64_t& generation, std::size_t& position) const;
  /// As since(), of the frames tracked: beyond kMostFrames older ones in coarser steps.
  static constexpr std::size_t kMostFrames = 50000;
  LogPiece<FrameRecord> framesSince(std::uint64_t& generation, std::size_t& position) const;
  /// Adds one frame, or replaces the same frame if it was the last one.
  void append(const FrameRecord& record);
  /// Appends the people of one frame, or replaces those of the last one if it is the same frame.
  /// Beyond kMostPeopleFrames (about 100 MB with two people), older frames are thinned out
  /// progressively.
  void append(PeopleFramePtr people);
  static constexpr std::size_t kMostPeopleFrames = 10000;
  std::vector<PeopleFramePtr> people() const;
  /// Notes a change in this frame after which the run no longer matches the header.
  void note(std::int64_t frame, const std::string& change);
  Trajectory trajectory() const;
  /// What the trajectory gained. `position` is where the last frame known to the reader begins: it
  /// may have been replaced, and comes again.
  LogPiece<TrajectorySample> samplesSince(std::uint64_t& generation, std::size_t& position) const;
  /// The boxes so far, where boxes are followed.
  BoxTrack boxTrack() const;
  /// As samplesSince(), of the boxes.
  LogPiece<BoxSample> boxesSince(std::uint64_t& generation, std::size_t& position) const;
  /// The results so far that other settings gave than those of now.
  void setOldResults(OldResults old);
  OldResults oldResults() const;
  Latency latency() const;
  /// Returns the data for run.json.
  std::pair<Project, RunFigures> run() const;

private:
  mutable std::mutex mutex_;
  std::uint64_t generation_ = 1;
  ThinnedLog<IterationRecord> records_;
  ThinnedLog<FrameRecord> frames_;
  ThinnedLog<PeopleFramePtr> people_;
  Trajectory trajectory_;
  std::vector<BoxSample> boxes_;
  Project project_;
  RunFigures figures_;
  OldResults oldResults_;
};

} // namespace dewpoint::session
